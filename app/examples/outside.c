/* A C client: makes a square of two faces, cuts it and counts the pieces.
 *   outside_c [SCENE]     SCENE: a folder for the result */
#include <kerf/kerf_c.h>
#include <stdio.h>

static int ended(kerf_result result) {
  if (result != KERF_OK) fprintf(stderr, "outside_c: %s\n", kerf_last_error());
  return result != KERF_OK;
}

int main(int argc, char** argv) {
  const double vertices[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const uint32_t faces[] = {0, 1, 2, 0, 2, 3};
  const kerf_keyframe keys[] = {{0, {0.5, -1, 1}, {0, 0, -1}}, {1, {0.5, 2, 1}, {0, 0, -1}}};
  kerf_stroke stroke = KERF_STROKE_INIT;
  kerf_mesh* square = NULL;
  kerf_world* world = NULL;
  kerf_mesh** pieces = NULL;
  size_t count = 0;
  stroke.keys = keys;
  stroke.key_count = 2;
  stroke.radius = 0.01;
  stroke.range[1] = 10;
  kerf_body_desc description = KERF_BODY_DESC_INIT;
  description.name = "square";
  int bad = ended(kerf_mesh_create(vertices, 4, faces, 2, &square)) || ended(kerf_world_create(&world)) ||
            ended(kerf_world_add(world, square, &description, NULL, NULL)) ||
            ended(kerf_world_cut(world, &stroke, 1, NULL, NULL, NULL)) ||
            ended(kerf_world_pieces(world, NULL, &pieces, &count));
  if (!bad) printf("%zu pieces\n", count);
  if (!bad && argc > 1) bad = ended(kerf_world_save_scene(world, argv[1]));
  kerf_pieces_free(pieces, count);
  kerf_world_destroy(world);
  kerf_mesh_destroy(square);
  return bad;
}
