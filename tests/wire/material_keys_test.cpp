#include "wire/material_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "wire/convert.h"

namespace gonio::wire {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string error_of(const char* json) {
  const auto material = material_from_json(json);
  return material ? "" : material.error().message;
}

TEST(MaterialKeys, AWrongKeyIsNamedWithTheNearest) {
  EXPECT_THAT(error_of(R"({"model": "ggx", "parametrs": {"f0": 1}})"),
              AllOf(HasSubstr("material.parametrs is not a field"),
                    HasSubstr("name, model, parameters, diffuse, specular"),
                    HasSubstr("did you mean \"parameters\"?")));
  EXPECT_THAT(error_of(R"({"specular": [{"model": "ggx"}, {"Modle": "ggx"}]})"),
              AllOf(HasSubstr("material.specular[1].Modle"), HasSubstr("mean \"model\"?")));
  EXPECT_THAT(error_of(R"({"diffuse": {"model": "lambertian", "params": {}}})"),
              HasSubstr("material.diffuse.params"));
  EXPECT_THAT(error_of(R"({"model": "ggx", "f0": 1})"),
              AllOf(HasSubstr("material.f0"), HasSubstr("within \"parameters\"")));
}

// Parameters are the model's to check; what is no object is the parser's.
TEST(MaterialKeys, LeavesTheRestToOthers) {
  for (const char* json : {R"({"model": "ggx", "parameters": {"any": {"thing": 1}}})", "[]", "{",
                           R"({"specular": {"model": "ggx"}})", R"({"specular": [1, null]})"})
    EXPECT_TRUE(check_material_keys(json).ok()) << json;
  EXPECT_THAT(error_of("{"), HasSubstr("not the JSON of a material"));
}

}  // namespace
}  // namespace gonio::wire
