/* An extension of a game engine, such as Godot, in C: the engine holds meshes as arrays of floats; a
 * laser cuts one of them; the pieces return as arrays of floats with a normal per corner, and with the
 * properties of a rigid body. main() stands in for the engine. */
#include <kerf/kerf_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* A surface in the format of engines: three corners per triangle, none shared. */
typedef struct surface {
  size_t corners;
  float *positions, *normals; /* three numbers per corner */
} surface;

/* A piece as a rigid body. */
typedef struct rigid_body {
  surface shape;
  double mass, centre[3], inertia[6];
} rigid_body;

static void free_bodies(rigid_body* bodies, size_t count) {
  for (size_t i = 0; bodies != NULL && i < count; ++i) {
    free(bodies[i].shape.positions);
    free(bodies[i].shape.normals);
  }
  free(bodies);
}

/* Converts the engine's indexed floats to a mesh of Kerf. */
static kerf_result take_mesh(const float* vertices, size_t vertex_count, const uint32_t* faces,
                             size_t face_count, kerf_mesh** out) {
  double* wide = malloc(3 * vertex_count * sizeof *wide);
  if (wide == NULL) return KERF_FAILED;
  for (size_t i = 0; i < 3 * vertex_count; ++i) wide[i] = vertices[i];
  const kerf_result result = kerf_mesh_create(wide, vertex_count, faces, face_count, out);
  free(wide);
  return result;
}

/* Writes the surface of a piece, relative to its centre of mass, flat-shaded. Returns 0 if memory is
 * short. */
static int give_surface(const kerf_mesh* piece, const double centre[3], surface* out) {
  const double* v = kerf_mesh_vertices(piece);
  const uint32_t* f = kerf_mesh_faces(piece);
  out->corners = 3 * kerf_mesh_face_count(piece);
  out->positions = malloc(3 * out->corners * sizeof(float));
  out->normals = malloc(3 * out->corners * sizeof(float));
  if (out->positions == NULL || out->normals == NULL) return 0;
  for (size_t t = 0; t < out->corners / 3; ++t) {
    const double *a = v + 3 * f[3 * t], *b = v + 3 * f[3 * t + 1], *c = v + 3 * f[3 * t + 2];
    double n[3], length = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
      length += n[k] * n[k];
    }
    length = sqrt(length);
    for (size_t corner = 0; corner < 3; ++corner) {
      const double* p = v + 3 * f[3 * t + corner];
      for (size_t k = 0; k < 3; ++k) {
        out->positions[3 * (3 * t + corner) + k] = (float)(p[k] - centre[k]);
        out->normals[3 * (3 * t + corner) + k] = (float)(length > 0 ? n[k] / length : 0);
      }
    }
  }
  return 1;
}

/* Cuts a mesh with one stroke, as a worker thread of the engine would. Returns null with *count = 0 on
 * failure. */
static rigid_body* cut(const kerf_mesh* mesh, const kerf_stroke* stroke, size_t* count) {
  kerf_cut_settings settings = KERF_CUT_SETTINGS_INIT;
  kerf_call_options one_thread = KERF_CALL_OPTIONS_INIT;
  kerf_world* world = NULL;
  kerf_mesh** pieces = NULL;
  rigid_body* bodies = NULL;
  size_t made = 0;
  *count = 0;
  settings.rim = KERF_RIM_SMOOTH;
  one_thread.threads = 1; /* the engine needs the other cores */
  if (kerf_world_create(&world) != KERF_OK ||
      kerf_world_add(world, mesh, NULL, &one_thread, NULL) != KERF_OK ||
      kerf_world_cut(world, stroke, 1, &settings, &one_thread, NULL) != KERF_OK ||
      kerf_world_pieces(world, &one_thread, &pieces, &made) != KERF_OK) {
    fprintf(stderr, "engine_extension: %s\n", kerf_last_error());
  } else if ((bodies = calloc(made, sizeof *bodies)) != NULL) {
    for (*count = 0; *count < made; ++*count) {
      rigid_body* body = bodies + *count;
      kerf_mesh_info info = KERF_MESH_INFO_INIT;
      kerf_mesh_get_info(pieces[*count], &info);
      body->mass = info.mass;
      for (int k = 0; k < 3; ++k) body->centre[k] = info.centroid[k];
      for (int k = 0; k < 6; ++k) body->inertia[k] = info.inertia[k];
      if (!give_surface(pieces[*count], body->centre, &body->shape)) break;
    }
  }
  kerf_pieces_free(pieces, made);
  kerf_world_destroy(world);
  return bodies;
}

int main(void) {
  /* A box of 2 m by 1 m by 1 m. */
  const float vertices[] = {-1, 0, -.5f, 1, 0, -.5f, 1, 0, .5f, -1, 0, .5f,
                            -1, 1, -.5f, 1, 1, -.5f, 1, 1, .5f, -1, 1, .5f};
  const uint32_t faces[] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5,
                            1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4};
  const kerf_keyframe keys[] = {{0, {0.2, 3, -2}, {0, -1, 0}}, {1, {0.2, 3, 2}, {0, -1, 0}}};
  kerf_stroke stroke = KERF_STROKE_INIT;
  kerf_mesh* box = NULL;
  stroke.keys = keys;
  stroke.key_count = 2;
  stroke.radius = 0.01;
  stroke.range[1] = 10;
  if (take_mesh(vertices, 8, faces, 12, &box) != KERF_OK) {
    fprintf(stderr, "engine_extension: %s\n", kerf_last_error());
    return 1;
  }
  size_t count = 0;
  rigid_body* bodies = cut(box, &stroke, &count);
  for (size_t i = 0; i < count; ++i)
    printf("rigid body of %zu corners, %.3f kg, centre %.3f %.3f %.3f\n", bodies[i].shape.corners,
           bodies[i].mass, bodies[i].centre[0], bodies[i].centre[1], bodies[i].centre[2]);
  free_bodies(bodies, count);
  kerf_mesh_destroy(box);
  return count == 2 ? 0 : 1;
}
