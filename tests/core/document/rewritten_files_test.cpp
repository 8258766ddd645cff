#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/json.h"
#include "core/document/journal.h"
#include "core/document/scene.h"
#include "core/document/stroke_path.h"
#include "core/document/text/fields.h"
#include "core/document/text/json.h"
#include "core/game/match/recording.h"
#include "tests/support/checkout.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

// Lines of journals, in the order of the kinds.
constexpr const char* kCommands[] = {
    R"({"do":"begin-stroke","settings":{"radius":0.0072,"range":[0.0,10.0],"pattern":"volume","power":2000.0,"scheme":"longest-edge","rule":"depth","target-edge":0.0018,"tolerance":9e-04,"depth":0,"rim":"faces"},"origin":[-0.33,2.9,1.43],"direction":[0.0,-1.0,0.0]})",
    R"({"do":"begin-stroke","settings":{"radius":1e-300,"range":[1e-300,3.5e-19],"pattern":"rays4","power":1e+05,"scheme":"one-to-four","rule":"tolerance","target-edge":1e-300,"tolerance":52712.0,"depth":1,"rim":"smooth","model":"thermal","heat-width":0.01,"wavelength":1.06e-05,"focus":0.5,"pulse-rate":100.0,"duty":0.25,"most-faces":1000},"origin":[-0.0,5e-324,1.0],"direction":[0.0,-1.0,0.0]})",
    R"({"do":"move-beam","origin":[5e-324,-48645338552423.25,-0.0],"direction":[0.70524924319674,0.6754068823171084,0.2155204126970554]})",
    R"({"do":"move-beam","origin":[0.18,2.9,1.4],"direction":[0.0,-1.0,0.0],"t":1.0})",
    R"({"do":"end-stroke"})",
    R"({"do":"stop-stroke","moves":274.284979655237})",
    R"({"do":"stop-stroke","moves":930.00255062149,"ticks":83})",
    R"({"do":"recut","settings":{"radius":0.01,"range":[0.0,10.0],"pattern":"volume","power":2000.0,"scheme":"longest-edge","rule":"target-edge","target-edge":0.0025,"tolerance":0.00125,"depth":4,"rim":"faces"}})",
    R"({"do":"advance-time","ticks":60})",
    R"({"do":"advance-time","ticks":5,"bodies":true,"joins":true})",
    R"({"do":"drag-body","piece":[1,0,5],"at":[5e-324,-0.0,1.5857161128510418e+29],"to":[332912.0,5e-324,5e-324]})",
    R"({"do":"release-body"})",
    R"({"do":"play"})",
    R"({"do":"add-mesh","mesh":"/some/folder/5.obj","name":"\"five\""})",
    R"({"do":"move-piece","piece":[3554524183,0,0],"position":[1017370.0,-0.0,-0.0],"orientation":[0.6869526189281636,-0.36361476411932975,0.3836745598475022,0.4986724724586339]})",
    R"({"do":"duplicate-piece","piece":[8,3,2],"position":[-0.0,-0.0,-0.0],"orientation":[1.0,0.0,0.0,0.0]})",
    R"({"do":"hide-piece","piece":[503271710,0,2],"hidden":true})",
    R"({"do":"delete-piece","piece":[6843023,0,1]})",
    R"({"do":"rename-piece","piece":[75483283,0,8],"name":""})",
    R"({"do":"pin-piece","piece":[282488087,0,4],"pinned":false})",
    R"({"do":"set-sheet-properties","piece":[4057680667,0,4],"thickness":0.039986902370558686,"density":5047.469406010302,"material-density":4765.107259176824,"heat-solid":8595.39582747604,"heat-liquid":5082.96669150497,"conductivity":3804.311622943342,"transition":9335.717000364459,"latent":5800.093087279847,"emissivity":0.5126051592265156,"absorptivity-fibre":0.268010161884443,"absorptivity-co2":0.3632782991116747,"wavelength":0.3068923524420671})",
    R"({"do":"set-solid","piece":[282488087,3,4],"solid":true})",
    R"({"do":"simplify-piece","piece":[644670122,0,6],"error":1e-300})",
    R"({"do":"simplify-piece","piece":[2304889889,0,4],"faces":71033493})",
    R"({"do":"subdivide-piece","piece":[403170315,0,7],"scheme":"loop"})",
    R"({"do":"smooth-piece","piece":[532165134,0,4],"times":4})",
    R"({"do":"turn-shells","piece":[532165134,4,2]})",
    R"({"do":"cut-plane","normal":[0.0,1.0,-0.5],"distance":0.25})",
    R"({"do":"cut-plane","normal":[0.0,1.0,-0.5],"distance":0.25,"pegs":{"count":2,"diameter":0.004,"depth":0.006,"tolerance":0.00025}})",
    R"({"do":"cut-plane","normal":[5e-324,-0.0,3.0],"distance":-1e+29,"bodies":[[1,0],[4,2]],"most-faces":5000})",
    R"({"do":"cut-path","poses":[{"origin":[0.0,1.0,0.5],"direction":[0.0,-1.0,0.0]},{"origin":[0.25,1.0,0.5],"direction":[0.0,-1.0,0.0]}],"range":[0.0,2.0]})",
    R"({"do":"join-parts","piece":[3,1,0],"joint":{"kind":"hinge","parts":["door","frame"],"anchor":[0.0,1.0,0.5],"axis":[0.0,2.0,0.0],"limits":[-90.0,5e-324],"near":[[0.0,1.0,0.5],[1e-300,1.0,0.5]],"radius":0.25}})",
    R"({"do":"join-parts","piece":[3,1,0],"joint":{"kind":"weld","anchor":[0.0,1.0,0.5],"near":[[0.0,1.0,0.5],[0.25,1.0,0.5]]}})",
    R"({"do":"set-environment","gravity":[0.0,-9.81,0.0]})",
    R"({"do":"set-environment","gravity":[0.0,-9810.0,0.0],"ground":-0.25,"metre":1000.0})",
    R"({"do":"undo"})",
    R"({"do":"redo"})"};

TEST(RewrittenFiles, commands_of_every_kind_round_trip) {
  std::set<size_t> kinds;
  for (const char* line : kCommands) {
    const auto json = nlohmann::json::parse(line);
    const auto command = parse_command(JsonValue(json, "line"), "/", std::nullopt);
    ASSERT_TRUE(command.ok()) << command.error().message;
    kinds.insert(command->index());
    EXPECT_EQ(*command_text(*command, "/elsewhere/deep"), line);
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<Command>);
}

TEST(RewrittenFiles, a_command_without_a_required_key_is_reported_as_damaged) {
  const std::set<std::pair<std::string, std::string>> optional{
      {"move-beam", "t"},        {"stop-stroke", "ticks"},     {"advance-time", "bodies"},
      {"advance-time", "joins"}, {"set-environment", "metre"}, {"set-environment", "ground"},
      {"cut-plane", "bodies"},   {"cut-plane", "most-faces"},  {"cut-plane", "pegs"}};
  for (const char* line : kCommands) {
    const auto json = nlohmann::json::parse(line);
    for (const auto& item : json.items()) {
      auto part = json;
      part.erase(item.key());
      const bool read = parse_command(JsonValue(part, "line"), "/", std::nullopt).ok();
      EXPECT_EQ(read, optional.contains({json["do"], item.key()})) << line << " without " << item.key();
    }
  }
}

TEST(RewrittenFiles, save_points_round_trip) {
  for (
      const char* line :
      {R"({"hash":"fedcba9876543210"})",
       R"({"hash":"0000000000000007","machine":"x86","clock":120,"bodies":[{"body":[1,2],"position":[100000.0,0.0001,-0.0],"orientation":[1.0,0.0,0.0,0.0],"velocity":[0.0,-1.5,0.0],"spin":[0.0,0.0,0.0],"quiet":3,"asleep":true}],"pairs":[[1,2,3,0,0,0],[1,2,1,7]]})"}) {
    const auto json = nlohmann::json::parse(line);
    StateMark mark;
    const Status read = read_fields(JsonValue(json, "line"), {}, mark);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(fields_json(mark, {}).dump(), line);
  }
}

// Whether a key with this value need not be written.
bool is_default(const std::string& key, const nlohmann::json& value) {
  const nlohmann::json defaults{{"position", {0, 0, 0}},
                                {"orientation", {1, 0, 0, 0}},
                                {"thickness", 0.001},
                                {"density", 7850},
                                {"joints", nlohmann::json::array()}};
  return defaults.contains(key) && defaults[key] == value;
}

// Returns true if `whole` contains all of `part`.
bool contains_all(const nlohmann::json& whole, const nlohmann::json& part) {
  if (!part.is_structured()) return whole == part;
  if (part.is_array() && whole.size() != part.size()) return false;
  for (const auto& item : part.items()) {
    if (part.is_object() && !whole.contains(item.key())) {
      if (is_default(item.key(), item.value())) continue;
      return false;
    }
    const nlohmann::json& other = part.is_object() ? whole[item.key()] : whole[std::stoul(item.key())];
    if (!contains_all(other, item.value())) return false;
  }
  return true;
}

std::vector<std::filesystem::path> files_in(const char* folder, const char* extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(checkout() / folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string journal_text(const Journal& journal, const std::filesystem::path& folder) {
  return *journal_head(journal.scene, journal.work_of, folder) +
         *journal_lines(journal.commands, journal.marks, folder);
}

// The text after the first line.
std::string body_of(const std::string& text) { return text.substr(text.find('\n') + 1); }

TEST(RewrittenFiles, stored_journals_and_recordings_round_trip) {
  size_t files = 0;
  for (const auto& file : files_in("tests/kept", ".kerf")) {
    SCOPED_TRACE(file.string());
    ++files;
    const auto folder = file.parent_path();
    if (is_recording(file)) {  // its head names the rules otherwise than Kerf does
      EXPECT_EQ(body_of(*recording_text(*read_recording(file), folder)), body_of(read_text(file)));
    } else {
      EXPECT_EQ(journal_text(*read_journal(file), folder), read_text(file));
    }
  }
  EXPECT_GE(files, 9u);
}

TEST(RewrittenFiles, journals_of_the_assets_keep_their_content) {
  TemporaryFolder folder;
  for (const auto& file : files_in("assets", ".kerf")) {
    SCOPED_TRACE(file.string());
    if (is_recording(file)) continue;
    const auto journal = read_journal(file);
    ASSERT_TRUE(journal.ok()) << journal.error().message;
    std::istringstream before(read_text(file)), after(journal_text(*journal, file.parent_path()));
    for (std::string a, b; std::getline(before, a);) {
      ASSERT_TRUE(std::getline(after, b));
      EXPECT_TRUE(contains_all(nlohmann::json::parse(b), nlohmann::json::parse(a))) << a << "\n" << b;
    }
    const std::string whole = journal_text(*journal, {});
    write_text(folder / "again.kerf", whole);
    EXPECT_EQ(journal_text(*read_journal(folder / "again.kerf"), {}), whole);
  }
}

TEST(RewrittenFiles, scenes_keep_their_content) {
  size_t scenes = 0;
  for (const auto& file : files_in("assets", ".json")) {
    const auto scene = read_description(file);
    if (!scene) continue;  // another kind of file
    SCOPED_TRACE(file.string());
    ++scenes;
    const auto written = scene_json(*scene, file.parent_path());
    auto before = nlohmann::json::parse(read_text(file));
    before.erase("strokes");  // of which directions become unit vectors
    EXPECT_TRUE(contains_all(written, before)) << written.dump(1);
    const auto again =
        parse_scene(JsonValue(nlohmann::json::parse(written.dump()), "again"), file.parent_path());
    EXPECT_EQ(scene_json(*again, file.parent_path()).dump(), written.dump());
  }
  EXPECT_GE(scenes, 10u);
}

}  // namespace
}  // namespace kerf::test
