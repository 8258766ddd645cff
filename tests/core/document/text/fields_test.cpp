#include "core/document/text/fields.h"
#include "core/base/json.h"

#include <gtest/gtest.h>

#include <array>

#include "core/document/text/json.h"

namespace kerf {

// A saved type with a field of each sort.
struct Lamp {
  double power = 5, age = 1;
  std::optional<double> height;
  size_t count = 3;
  bool on = false;
  int shade = 0;
  std::string name = "lamp";
  Vec3 at{0};
  std::vector<Lamp> parts;
  std::string others = "{}";
};

static void describe(Fields& f, Lamp& lamp) {
  constexpr std::array kShades{"clear", "matt", "dark"};
  f.number("power", lamp.power, {1, 1000, "W"});
  f.number("age", lamp.age, {0, 100, "years"}, 7);
  f.number("height", lamp.height, kPositive);
  f.whole("count", lamp.count, 1, 9, kOptional);
  f.flag("on", lamp.on, false);
  f.choice("shade", lamp.shade, kShades, 0);
  f.filled_text("name", lamp.name, kOptional);
  f.vector("at", lamp.at, VectorRule::kNearby, kOptional);
  f.list("parts", "lamps", lamp.parts, kOptional);
  constexpr std::array kKept{"weight"};
  f.kept(kKept, lamp.others);
}

namespace test {
namespace {

Status read(const std::string& text, Lamp& lamp) {
  return read_text_fields(text, "lamp.json", {}, [&](Fields& f) { describe(f, lamp); });
}

std::string error_of(const std::string& text) {
  Lamp lamp;
  const Status status = read(text, lamp);
  return status ? "" : status.error().message;
}

TEST(Fields, a_key_that_is_twice_in_an_object_is_refused_with_its_line) {
  const auto fault = [](const std::string& text) {
    const Status unique = check_unique_keys(text, "a.json");
    return unique ? std::string() : unique.error().message;
  };
  EXPECT_EQ(fault("{\"a\": 1,\n\"b\": [{\"a\": 2}, {\"a\": \"a\"}]}"), "");
  EXPECT_EQ(fault("{\"a\": 1,\n \"b\": 2,\n \"a\" : 3}"),
            "a.json: line 3: the key \"a\" is in this object twice");
  EXPECT_EQ(fault("[{\"a\": {\"b\": 1, \"c\": {}, \"b\": 2}}]"),
            "a.json: line 1: the key \"b\" is in this object twice");
  // Strings may hold brackets, quotes and text like keys.
  EXPECT_EQ(fault(R"({"a}": "{\\", "b\"": "\"c\": {", "c": ["c", "c"], "": ":"})"), "");
  EXPECT_EQ(fault("5"), "");
  // The text ends at a null character.
  EXPECT_EQ(fault(std::string("{}\0}\"", 5)), "");
}

TEST(Fields, missing_keys_get_the_defaults_of_the_table) {
  Lamp lamp;
  ASSERT_TRUE(read(R"({"power": 60})", lamp).ok());
  EXPECT_EQ(lamp.power, 60);
  EXPECT_EQ(lamp.age, 7);
  EXPECT_FALSE(lamp.height);
  EXPECT_EQ(lamp.count, 3u);
}

TEST(Fields, are_written_in_table_order_without_defaults) {
  Lamp lamp;
  lamp.age = 7;
  EXPECT_EQ(fields_json(lamp, {}).dump(), R"({"power":5.0,"count":3,"name":"lamp","at":[0.0,0.0,0.0]})");
  lamp.age = 8;
  lamp.height = 2;
  lamp.shade = 2;
  lamp.parts.resize(1);
  EXPECT_EQ(
      fields_json(lamp, {}).dump(),
      R"({"power":5.0,"age":8.0,"height":2.0,"count":3,"shade":"dark","name":"lamp","at":[0.0,0.0,0.0],)"
      R"("parts":[{"power":5.0,"age":1.0,"count":3,"name":"lamp","at":[0.0,0.0,0.0]}]})");
}

TEST(Fields, unknown_but_preserved_keys_are_not_parsed) {
  Lamp lamp;
  ASSERT_TRUE(read(R"({"power": 60, "weight": [1, 2], "age": 3})", lamp).ok());
  EXPECT_EQ(lamp.others, R"({"weight":[1,2]})");
  EXPECT_EQ(fields_json(lamp, {})["weight"].dump(), "[1,2]");
}

TEST(Fields, report_file_location_and_expected_value) {
  EXPECT_EQ(error_of("{\n\"power\": }"), "lamp.json: line 2: this is not JSON");
  EXPECT_EQ(error_of("# a\nv 0 0 0\n"), "lamp.json: line 1: this is an OBJ mesh, not JSON");
  EXPECT_EQ(error_of("<svg width='1'>"), "lamp.json: line 1: this is an SVG drawing, not JSON");
  EXPECT_EQ(error_of("[]"), "lamp.json: must be an object");
  EXPECT_EQ(error_of("{}"), "lamp.json: needs \"power\"");
  EXPECT_EQ(error_of(R"({"power": "much"})"), "lamp.json: /power: must be a finite number");
  EXPECT_EQ(error_of(R"({"power": 0.5})"), "lamp.json: /power: must be from 1 to 1000 W");
  EXPECT_EQ(error_of(R"({"power": 5, "height": 0})"), "lamp.json: /height: must be greater than zero");
  EXPECT_EQ(error_of(R"({"power": 5, "count": 1.5})"),
            "lamp.json: /count: must be a whole number from 1 to 9");
  EXPECT_EQ(error_of(R"({"power": 5, "count": -1})"),
            "lamp.json: /count: must be a whole number from 1 to 9");
  EXPECT_EQ(error_of(R"({"power": 5, "on": 1})"), "lamp.json: /on: must be true or false");
  EXPECT_EQ(error_of(R"({"power": 5, "shade": "red"})"),
            R"(lamp.json: /shade: must be "clear", "matt" or "dark")");
  EXPECT_EQ(error_of(R"({"power": 5, "name": ""})"), "lamp.json: /name: must not be empty");
  EXPECT_EQ(error_of(R"({"power": 5, "at": [1, 2]})"), "lamp.json: /at: must be three numbers");
  EXPECT_EQ(error_of(R"({"power": 5, "at": [1, 2, 1e6]})"),
            "lamp.json: /at: is more than 100000 m from the origin");
  EXPECT_EQ(error_of(R"({"power": 5, "parts": {}})"), "lamp.json: /parts: must be an array of lamps");
  EXPECT_EQ(error_of(R"({"power": 5, "parts": [{"power": 5}, 7]})"),
            "lamp.json: /parts/1: must be an object");
  EXPECT_EQ(error_of(R"({"power": 5, "parts": [{"power": 0}, 7]})"),
            "lamp.json: /parts/0/power: must be from 1 to 1000 W");
}

TEST(Fields, unknown_keys_are_rejected_with_the_nearest_name) {
  const auto unknown = [](const std::string& pointer, const std::string& nearest) {
    return "lamp.json: " + pointer + ": is not a valid key here in this version; the nearest name is \"" +
           nearest + '"';
  };
  EXPECT_EQ(error_of(R"({"power": 5, "hieght": 1})"), unknown("/hieght", "height"));
  EXPECT_EQ(error_of(R"({"power": 5, "Count": 1})"), unknown("/Count", "count"));
  EXPECT_EQ(error_of(R"({"power": 5, "nam": "x"})"), unknown("/nam", "name"));
  EXPECT_EQ(error_of(R"({"power": 5, "na\nme": "x"})"), unknown("/na?me", "name"));
  EXPECT_EQ(error_of(R"({"power": 5, "parts": [{"power": 5}, {"power": 5, "shades": 1}]})"),
            unknown("/parts/1/shades", "shade"));
}

TEST(Fields, newer_versions_are_rejected) {
  const auto error_of_version = [](const std::string& text) {
    uint64_t version = 0;
    const Status status =
        read_text_fields(text, "x", {}, [&](Fields& f) { f.version("version", version, 2); });
    return status ? std::to_string(version) : status.error().message;
  };
  EXPECT_EQ(error_of_version(R"({"version": 1})"), "1");
  EXPECT_EQ(error_of_version(R"({"version": 2})"), "2");
  EXPECT_EQ(error_of_version(R"({"version": 3})"),
            "x: /version: the file is of a newer version of Kerf: this one reads version 2");
  for (const char* wrong : {"0", "\"2\"", "null", "-1", "1.5"})
    EXPECT_EQ(error_of_version(std::string(R"({"version": )") + wrong + "}"),
              "x: /version: must be a whole number from 1 to 2");
}

}  // namespace
}  // namespace test
}  // namespace kerf
