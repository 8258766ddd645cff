"""Cuts what it receives: reads jobs from standard input, a JSON object per line, and answers each with a line.

A job has a mesh, as "vertices" and "faces" or as the bytes of a file in base64 ("mesh"), "strokes", each with the
arguments of kerf.Stroke, and perhaps "material", "rim" and "target_edge". An answer has "pieces", or an "error".
    echo '{"vertices": [[0,0,0],[1,0,0],[0,0,1]], "faces": [[0,2,1]], "strokes": []}' | python3 cut_server.py
"""
import base64
import json
import sys

import kerf


def run(job):
    if 'mesh' in job:
        mesh = kerf.Mesh.decode(base64.b64decode(job['mesh']))
    else:
        mesh = kerf.Mesh(job['vertices'], job['faces'])
    world = kerf.World()
    world.add(mesh, material=job.get('material'))
    settings = {key: job[key] for key in ('rim', 'target_edge') if key in job}
    cut = world.cut([kerf.Stroke(**stroke) for stroke in job['strokes']], **settings)
    return {'removed_area': cut['removed_area'], 'warnings': mesh.warnings, 'pieces': [
        {'area': piece.area, 'mass': piece.mass, 'centroid': piece.centroid.tolist(),
         'mesh': base64.b64encode(piece.encode('ply')).decode()} for piece in world.pieces]}


for line in sys.stdin:
    try:
        answer = run(json.loads(line))
    except (ValueError, TypeError, KeyError, kerf.Error) as fault:
        answer = {'error': f'{type(fault).__name__}: {fault}'}
    print(json.dumps(answer), flush=True)
