#ifndef KERF_KERF_C_MESH_H
#define KERF_KERF_C_MESH_H

/* Meshes of the C library, and what all of its calls share: the version, results, and options. kerf_c.h
 * includes this header and states the units, frames, errors and threads. */

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/* The version of this header, in numbers that grow: 200 is 0.2.0. */
#define KERF_VERSION_MAJOR 0
#define KERF_VERSION_MINOR 2
#define KERF_VERSION_PATCH 0
#define KERF_VERSION (KERF_VERSION_MAJOR * 10000 + KERF_VERSION_MINOR * 100 + KERF_VERSION_PATCH)

#if defined(__GNUC__)
#define KERF_API __attribute__((visibility("default")))
#else
#define KERF_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum kerf_result {
  KERF_OK = 0,
  KERF_FAILED = 1,           /* the operation failed: disk full, out of memory */
  KERF_INVALID_ARGUMENT = 2, /* an argument or a file is invalid */
  KERF_CANCELLED = 3,        /* the progress callback cancelled the call */
  KERF_BUSY = 4              /* another call or a stroke in steps uses the world; see kerf_c.h */
} kerf_result;

/* Returns the version of the library, such as "0.2.0"; a static string. */
KERF_API const char* kerf_version(void);

/* Returns the message of the last failed call in this thread; empty if no call has failed. Valid until the
 * next failed call in this thread. */
KERF_API const char* kerf_last_error(void);

/* Progress callback, called on the caller's thread, from a few hundred to a few thousand times in a long
 * call. Must not throw. Calls on the same world fail with KERF_BUSY, except for queries within a query.
 * fraction: completed part of the work, 0 to 1.
 * user: kerf_call_options::user.
 * Returns 0 to continue; any other value ends the call with KERF_CANCELLED. */
typedef int (*kerf_progress)(double fraction, void* user);

/* Options of a call. A null pointer instead is the default. */
typedef struct kerf_call_options {
  size_t size;
  kerf_progress progress; /* may be null */
  void* user;             /* passed to `progress` */
  unsigned threads;       /* maximum number of threads, 0 to 1024; 0: one per processor */
} kerf_call_options;
#define KERF_CALL_OPTIONS_INIT \
  { sizeof(kerf_call_options), NULL, NULL, 0 }

/* -- Meshes -- */

/* A triangle mesh, or a piece of one; immutable. */
typedef struct kerf_mesh kerf_mesh;

/* Reads a mesh file. Welds equal positions; drops faces with an index out of range, a non-finite
 * position, two corners at the same position, or fewer than three corners. Lengths in OBJ, PLY, STL and OFF
 * count as metres; 3MF is converted to metres.
 * path: an OBJ, PLY, STL, OFF, glTF, 3MF or Kerf (.kmesh) file; the content decides the format.
 * Errors: KERF_INVALID_ARGUMENT if the file cannot be opened or parsed, or has no usable face;
 * KERF_CANCELLED. O(file size). */
KERF_API kerf_result kerf_mesh_read(const char* path, const kerf_call_options* options, kerf_mesh** out);

/* Creates a mesh from arrays, which are copied. Equal positions are welded when it is added to a world.
 * vertices: vertex_count positions (m), finite; faces: face_count triples of indices < vertex_count.
 * vertex_count, face_count: 1 to 2^31.
 * Errors: KERF_INVALID_ARGUMENT if an array violates the above. O(n). */
KERF_API kerf_result kerf_mesh_create(const double* vertices, size_t vertex_count, const uint32_t* faces,
                                      size_t face_count, kerf_mesh** out);

/* Format of the vertex and index buffers of a renderer. Strides need no alignment. */
typedef struct kerf_layout {
  size_t size;
  size_t vertex_stride; /* bytes from the position of a vertex to the next; 0: no gap */
  size_t face_stride;   /* bytes from the three indices of a face to the next; 0: no gap */
  int is_float;         /* 1: positions are three floats, 0: three doubles */
  int is_16_bit;        /* 1: indices are uint16_t, 0: uint32_t */
} kerf_layout;
#define KERF_LAYOUT_INIT \
  { sizeof(kerf_layout), 0, 0, 0, 0 }

/* Creates a mesh from buffers, which are copied.
 * layout: null: that of kerf_mesh_create, whose other arguments and errors it has. O(n). */
KERF_API kerf_result kerf_mesh_create_from(const void* vertices, size_t vertex_count, const void* faces,
                                           size_t face_count, const kerf_layout* layout, kerf_mesh** out);

/* Writes the positions and faces of a mesh to buffers; bytes between them stay as they are.
 * layout: may be null.
 * vertices, faces: room for kerf_mesh_vertex_count and kerf_mesh_face_count elements; may be null.
 * Errors: KERF_INVALID_ARGUMENT for a stride below an element, or too many vertices for 16 bits. O(n). */
KERF_API kerf_result kerf_mesh_copy_to(const kerf_mesh* mesh, const kerf_layout* layout, void* vertices,
                                       void* faces);

/* Reads a mesh from the bytes of a file, like kerf_mesh_read. Files to which the bytes refer are not read.
 * format: a hint, "obj", "ply", "stl", "off", "glb", "gltf" or "3mf"; null: none.
 * Errors: KERF_INVALID_ARGUMENT for bytes that cannot be parsed, or have no usable face. O(byte_count). */
KERF_API kerf_result kerf_mesh_decode(const void* bytes, size_t byte_count, const char* format,
                                      const kerf_call_options* options, kerf_mesh** out);

/* Returns the bytes that kerf_mesh_write writes.
 * format: as above, not null.
 * bytes: receives *byte_count bytes; free them with kerf_text_free.
 * Errors: KERF_INVALID_ARGUMENT for another format, KERF_FAILED if the format cannot store the mesh. O(n). */
KERF_API kerf_result kerf_mesh_encode(const kerf_mesh* mesh, const char* format, char** bytes,
                                      size_t* byte_count);

/* Warnings from reading the mesh, such as dropped faces. The first function returns their number, 0 if `mesh`
 * is null; the second one of them, a sentence valid while the mesh exists, null if there is none. O(1). */
KERF_API size_t kerf_mesh_warning_count(const kerf_mesh* mesh);
KERF_API const char* kerf_mesh_warning(const kerf_mesh* mesh, size_t warning);

/* Destroys a mesh. No-op if `mesh` is null. */
KERF_API void kerf_mesh_destroy(kerf_mesh* mesh);

/* Writes a mesh to a file atomically: a failed call leaves no partial file.
 * path: its extension decides the format: .obj, .ply, .stl, .off, .glb, .gltf or .3mf.
 * Errors: KERF_INVALID_ARGUMENT for another extension, KERF_FAILED if the file cannot be written. O(n). */
KERF_API kerf_result kerf_mesh_write(const kerf_mesh* mesh, const char* path);

/* Returns a mesh as bytes, with its attributes, materials and images, from which kerf_mesh_from_bytes creates
 * it to the bit. Omits what only a piece has: its name, mass and temperatures.
 * out, size: receive the bytes and their number; free them with kerf_text_free.
 * Errors: KERF_INVALID_ARGUMENT for a null argument. O(n). */
KERF_API kerf_result kerf_mesh_to_bytes(const kerf_mesh* mesh, char** out, size_t* size);

/* Creates a mesh from such bytes.
 * Errors: KERF_INVALID_ARGUMENT for other or damaged bytes, and those of a later version. O(n). */
KERF_API kerf_result kerf_mesh_from_bytes(const char* bytes, size_t size, kerf_mesh** out);

/* Return the number of vertices or faces; 0 if `mesh` is null. O(1). */
KERF_API size_t kerf_mesh_vertex_count(const kerf_mesh* mesh);
KERF_API size_t kerf_mesh_face_count(const kerf_mesh* mesh);

/* Return the positions, 3 numbers per vertex (m), or the faces, 3 vertex indices each; null if `mesh` is
 * null. Valid while the mesh exists. O(1). */
KERF_API const double* kerf_mesh_vertices(const kerf_mesh* mesh);
KERF_API const uint32_t* kerf_mesh_faces(const kerf_mesh* mesh);

/* Returns the temperatures of the faces of a piece (K); null for another mesh. Valid while the mesh exists.
 * O(1). */
KERF_API const double* kerf_mesh_face_temperatures(const kerf_mesh* mesh);

/* Attributes of a mesh: values at the corners of its faces, as read or interpolated by cuts. Names are as in
 * glTF: TEXCOORD_0 and so on (v = 0 is the top of an image), NORMAL, TANGENT, and _NAME for custom ones. */

/* Return the number of attributes; the name of one, valid while the mesh exists; and its numbers per corner,
 * 1 to 4. Null or 0 if there is none. O(1). */
KERF_API size_t kerf_mesh_attribute_count(const kerf_mesh* mesh);
KERF_API const char* kerf_mesh_attribute_name(const kerf_mesh* mesh, size_t attribute);
KERF_API size_t kerf_mesh_attribute_size(const kerf_mesh* mesh, size_t attribute);

/* Copies an attribute. values: receives its numbers for each corner of each face; NaN if there are none.
 * Errors: KERF_INVALID_ARGUMENT if there is no such attribute. O(n). */
KERF_API kerf_result kerf_mesh_get_attribute(const kerf_mesh* mesh, size_t attribute, float* values);

/* Return the index of the material of each face, null if the mesh has no materials; the number of named
 * materials; and the name of one, which may be empty, null if there is none. Valid while the mesh exists.
 * O(1). */
KERF_API const uint16_t* kerf_mesh_face_materials(const kerf_mesh* mesh);
KERF_API size_t kerf_mesh_material_count(const kerf_mesh* mesh);
KERF_API const char* kerf_mesh_material_name(const kerf_mesh* mesh, size_t material);

/* Named parts of a mesh that was read, such as the objects and groups of OBJ: ranges of its faces, which may
 * overlap; names may repeat. */

/* Returns the number of parts; 0 if `mesh` is null. O(1). */
KERF_API size_t kerf_mesh_part_count(const kerf_mesh* mesh);

/* Writes the name of a part, valid while the mesh exists, its first face and its number of faces.
 * Errors: KERF_INVALID_ARGUMENT if there is no such part. O(1). */
KERF_API kerf_result kerf_mesh_get_part(const kerf_mesh* mesh, size_t part, const char** name, size_t* first,
                                        size_t* count);

/* Properties of a mesh. Mass and inertia are 0 unless the mesh is a piece of a world. */
typedef struct kerf_mesh_info {
  size_t size;
  const char* name;      /* name of the piece, else empty; valid while the mesh exists */
  double area;           /* m^2 */
  double centroid[3];    /* of the area, or of the volume of a solid [m] */
  size_t boundary_edges; /* number of edges with one face; 0 unless the mesh is a piece */
  double mass;           /* kg: of a solid if the body is solid and the piece is closed, else of a sheet */
  double inertia[6];     /* kg m^2 about the centroid in world axes: xx yy zz xy xz yz */
  double position[3];    /* of the body that owns the piece [m]: x_world = orientation * x_body + position */
  double orientation[4]; /* quaternion w x y z; the vertices are already in world coordinates */
  double volume;         /* m^3, of a closed piece; 0 for an open one and any other mesh */
  int is_closed;         /* 1 if a piece uses each edge equally often in both directions, else 0 */
  int reserved;          /* 0 */
} kerf_mesh_info;
#define KERF_MESH_INFO_INIT \
  { sizeof(kerf_mesh_info), NULL, 0, {0, 0, 0}, 0, 0, {0, 0, 0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0, 0}, 0, 0, 0 }

/* Writes the properties of a mesh. info: its size is set; zeros if `mesh` is null.
 * Errors: KERF_INVALID_ARGUMENT for a null `info` or an invalid size. O(1). */
KERF_API kerf_result kerf_mesh_get_info(const kerf_mesh* mesh, kerf_mesh_info* info);

/* Computes the Euler number of a mesh, vertices - edges + faces. Equal positions count as one vertex if the
 * mesh is a piece or was read from a file. O(n log n). */
KERF_API kerf_result kerf_mesh_euler_number(const kerf_mesh* mesh, int64_t* out);

#ifdef __cplusplus
}
#endif

#endif
