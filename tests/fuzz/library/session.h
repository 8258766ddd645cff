#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/kerf_c.h"
#include "tests/fuzz/strokes/byte_source.h"

namespace kerf::fuzz {

// A client of the C library, with a world in which a plate lies, that calls its functions in any order.
// Pointers are null or point to what a function wants; all other arguments may have any value. Each call is
// checked: a failure has a sentence and changes nothing, neither the world nor what is pointed to, and a
// journal or a scene that was saved is opened again.
class Session {
 public:
  // `folder` exists and is empty. Files are read and written there.
  Session(ByteSource& bytes, std::filesystem::path folder);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Makes the call that the next bytes select.
  void act();

 private:
  // When a progress function stops its call, and the world with which it calls the library itself, or null.
  struct Patience {
    int calls_left;
    kerf_world* calls_with;
  };

  void make_mesh();
  void read_mesh();
  void write_mesh();
  void inspect_mesh();
  void make_world();
  void open_world();
  void add();
  void cut();
  void cut_in_steps();
  void convert_mesh();
  void edit();
  kerf_result join(kerf_world* in, kerf_body of);
  void travel();
  void take_changes();
  void take_pieces();
  void cast_rays();
  void save_scene();
  void save_journal();
  void report();
  void free_one();

  bool chance(size_t n) { return bytes_.below(n) == n - 1; }
  // The pointer, seldom null instead.
  template <typename T>
  T* or_null(T* pointer) {
    return chance(32) ? nullptr : pointer;
  }
  double number();
  double length();
  std::vector<double> numbers(size_t count);
  std::string path();
  kerf_world* world();
  kerf_mesh* mesh();
  kerf_body body(const kerf_world* of);
  const kerf_call_options* control(kerf_world* in_use);
  kerf_stroke stroke();
  kerf_cut_settings settings();
  void keep(kerf_mesh* mesh);
  void keep(kerf_world* world);

  // The result of a call that may change the world, which must be as it was if it failed.
  kerf_result change(kerf_world* world, const std::function<kerf_result()>& call);
  static int on_progress(double share, void* user);

  ByteSource& bytes_;
  std::filesystem::path folder_;
  std::vector<kerf_world*> worlds_;
  std::vector<kerf_mesh*> meshes_;
  Patience patience_{};
  kerf_call_options control_{};
  std::vector<std::vector<kerf_keyframe>> keys_;  // of the strokes of a cut
};

}  // namespace kerf::fuzz
