/* An extension of a game engine, such as Godot, in C: meshes are floats and 16-bit indices; a laser cuts one
 * in steps, each frame uploads only the faces that changed, and the pieces become rigid bodies. main() stands
 * in for the engine. engine_extension [SCENE]     SCENE: a folder for the result */
#include <kerf/kerf_c.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_FACES (1 << 18)

static float vertex_buffer[9 * MAX_FACES]; /* by face index; a removed face has no area */
static size_t uploaded;

static kerf_result upload(const kerf_world* world, kerf_body body, const uint32_t* faces, size_t n) {
  double* corners = malloc((9 * n + 1) * sizeof *corners);
  kerf_result result = KERF_FAILED;
  if (corners != NULL && (n == 0 || faces[n - 1] < MAX_FACES))
    result = kerf_body_get_faces(world, body, faces, n, corners, NULL, NULL, NULL);
  for (size_t i = 0; result == KERF_OK && i < 9 * n; ++i)
    vertex_buffer[9 * faces[i / 9] + i % 9] = (float)corners[i];
  uploaded += n;
  free(corners);
  return result;
}

static kerf_result draw_frame(kerf_world* world) {
  kerf_changes changes = KERF_CHANGES_INIT;
  kerf_result result = kerf_world_take_changes(world, &changes);
  for (size_t b = 0; result == KERF_OK && b < changes.body_count; ++b) {
    const kerf_body_changes* body = &changes.bodies[b];
    for (size_t i = 0; i < body->removed_count; ++i)
      if (body->removed[i] < MAX_FACES) memset(vertex_buffer + 9 * body->removed[i], 0, 9 * sizeof(float));
    result = upload(world, body->body, body->added, body->added_count);
  }
  return result;
}

static int ended(kerf_result result) {
  if (result != KERF_OK) fprintf(stderr, "engine_extension: %s\n", kerf_last_error());
  return result != KERF_OK;
}

int main(int argc, char** argv) {
  /* A box of 2 m by 1 m by 1 m. */
  const float vertices[] = {-1, 0, -.5f, 1, 0, -.5f, 1, 0, .5f, -1, 0, .5f,
                            -1, 1, -.5f, 1, 1, -.5f, 1, 1, .5f, -1, 1, .5f};
  const uint16_t faces[] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5,
                            1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4};
  const kerf_keyframe keys[] = {{0, {0.2, 3, -2}, {0, -1, 0}}, {1, {0.2, 3, 2}, {0, -1, 0}}};
  const kerf_layout layout = {sizeof layout, 0, 0, 1, 1}; /* floats and 16 bits */
  kerf_stroke stroke = KERF_STROKE_INIT;
  kerf_cut_settings settings = KERF_CUT_SETTINGS_INIT;
  kerf_stroke_progress progress = KERF_STROKE_PROGRESS_INIT;
  kerf_mesh *box = NULL, **pieces = NULL;
  kerf_world* world = NULL;
  size_t count = 0;
  stroke.keys = keys, stroke.key_count = 2;
  stroke.radius = 0.01, stroke.range[1] = 10;
  settings.rim = KERF_RIM_SMOOTH;
  int bad = ended(kerf_mesh_create_from(vertices, 8, faces, 12, &layout, &box)) ||
            ended(kerf_world_create(&world)) || ended(draw_frame(world)) ||
            ended(kerf_world_add(world, box, NULL, NULL, NULL)) || ended(draw_frame(world)) ||
            ended(kerf_stroke_begin(world, &stroke, &settings)) || ended(kerf_stroke_end(world));
  while (!bad && !progress.is_finished)
    bad = ended(kerf_stroke_step(world, SIZE_MAX, 0.002, &progress)) || ended(draw_frame(world));
  bad = bad || ended(kerf_world_pieces(world, NULL, &pieces, &count));
  for (size_t i = 0; i < count; ++i) {
    kerf_mesh_info info = KERF_MESH_INFO_INIT;
    kerf_mesh_get_info(pieces[i], &info);
    const double* centre = info.centroid;
    printf("rigid body of %zu faces, %.3f kg, centre %.3f %.3f %.3f\n", kerf_mesh_face_count(pieces[i]),
           info.mass, centre[0], centre[1], centre[2]);
  }
  if (!bad && argc > 1) bad = ended(kerf_world_save_scene(world, argv[1]));
  kerf_pieces_free(pieces, count);
  kerf_world_destroy(world);
  kerf_mesh_destroy(box);
  return bad || count != 2 || uploaded == 0;
}
