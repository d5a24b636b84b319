// What is wrong with a material is said by field, value and what is allowed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/support/harness.h"
#include "wire/convert.h"

namespace gonio::server::testing {
namespace {

using ::testing::HasSubstr;

struct BadMaterial {
  const char* name;
  const char* json;
  const char* field;
  const char* value;
  const char* allowed;
  ErrorCode code = ErrorCode::invalid_argument;
};

const BadMaterial kBadMaterials[] = {
    {"Empty", "{}", "material", "empty", "exactly one of"},
    {"NameAndModel", R"({"name": "a", "model": "ggx"})", "material", "2 ways", "exactly one of"},
    {"ModelAndSum", R"({"model": "ggx", "diffuse": {"model": "lambertian"}})", "material", "2 ways",
     "exactly one of"},
    {"AllThree", R"({"name": "a", "model": "ggx", "specular": [{"model": "ggx"}]})", "material",
     "3 ways", "exactly one"},
    {"ParametersOfNothing", R"({"name": "a", "parameters": {"rd": 1}})", "material.parameters",
     "without a model", "beside"},
    {"UnknownStored", R"({"name": "brass"})", "material.name", "brass", "none",
     ErrorCode::not_found},
    {"UnknownModel", R"({"model": "ggxx"})", "material.model", "ggxx", "lambertian",
     ErrorCode::not_found},
    {"UnknownModelInSum", R"({"specular": [{"model": "ggx"}, {"model": "x"}]})",
     "material.specular[1].model", "x", "ggx", ErrorCode::not_found},
    {"LobeWithoutModel", R"({"diffuse": {}})", "material.diffuse.model", "", "lambertian",
     ErrorCode::not_found},
    {"UnknownParameter", R"({"model": "lambertian", "parameters": {"dr": 1}})",
     "material.parameters.dr", "", "rd"},
    {"OutOfBounds", R"({"model": "ggx", "parameters": {"alpha_x": 7}})",
     "material.parameters.alpha_x", "7", "1"},
    {"OutOfBoundsInSum",
     R"({"diffuse": {"model": "lambertian", "parameters": {"rd": [0.1, 2, 0.3]}}})",
     "material.diffuse.parameters.rd[1]", "2", "1"},
    {"RotationBeyondATurn", R"({"model": "ggx", "rotation": 181})", "material.rotation", "181",
     "[-180, 180]"},
    {"RotationOfASumThatIsNone", R"({"specular": [{"model": "ggx"}], "rotation": "NaN"})",
     "material.rotation", "nan", "[-180, 180]"},
    {"RotationOfWhatHasNoTangents", R"({"model": "lambertian", "rotation": "Infinity"})",
     "material.rotation", "inf", "[-180, 180]"},
    {"RotationOfNothing", R"({"rotation": 30})", "material", "empty", "exactly one of"},
    {"Bool", R"({"model": "ggx", "parameters": {"alpha_x": true}})", "material.parameters.alpha_x",
     "true", "a number"},
    {"Null", R"({"model": "ggx", "parameters": {"alpha_x": null}})", "material.parameters.alpha_x",
     "null", "a number"},
    {"Object", R"({"model": "ggx", "parameters": {"alpha_x": {"v": 1}}})",
     "material.parameters.alpha_x", "an object", "a number"},
    {"NestedArray", R"({"model": "ggx", "parameters": {"f0": [1, [2]]}})",
     "material.parameters.f0[1]", "an array", "a number"},
    {"WordInArray", R"({"specular": [{"model": "ggx", "parameters": {"f0": ["x"]}}]})",
     "material.specular[0].parameters.f0[0]", "\"x\"", "a number"},
    {"EmptyArray", R"({"model": "ggx", "parameters": {"f0": []}})", "material.parameters.f0", "",
     ""},
    {"WordForANumber", R"({"model": "ggx", "parameters": {"alpha_x": "wide"}})",
     "material.parameters.alpha_x", "wide", "number"},
    {"NumberForAWord", R"({"model": "ggx", "parameters": {"fresnel": 3}})",
     "material.parameters.fresnel", "a number", "schlick"},
    {"UnknownWord", R"({"model": "ggx", "parameters": {"fresnel": "metal"}})",
     "material.parameters.fresnel", "metal", "conductor"},
    {"FiveLobes",
     R"({"specular": [{"model": "ggx"}, {"model": "ggx"}, {"model": "ggx"}, {"model": "ggx"}, {"model": "ggx"}]})",
     "material.specular", "5", "4"},
    {"DiffuseAsSpecular", R"({"specular": [{"model": "lambertian"}]})",
     "material.specular[0].model", "lambertian", ""},
    {"ColoursOfTwoLengths", R"({"model": "ggx", "parameters": {"f0": [1, 1, 1], "scale": [1, 1]}})",
     "material.parameters.scale", "2", "3"},
    {"MeasuredFile", R"({"model": "measured", "parameters": {"file": "/etc/passwd"}})",
     "material.model", "measured", "stores"},
    {"MeasuredInASum", R"({"specular": [{"model": "measured", "parameters": {"file": "x"}}]})",
     "material.specular[0].model", "measured", ""},
};

class MaterialErrors : public ::testing::TestWithParam<BadMaterial> {};

TEST_P(MaterialErrors, NameFieldValueAndAllowed) {
  TestServer server;
  const auto material = wire::material_from_json(GetParam().json);
  ASSERT_TRUE(material.ok());
  v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
  *request.mutable_material() = *material;
  const Error error = server.refused(request);
  EXPECT_EQ(error.code, GetParam().code);
  EXPECT_EQ(error.field, GetParam().field);
  EXPECT_THAT(error.value, HasSubstr(GetParam().value));
  EXPECT_THAT(error.allowed, HasSubstr(GetParam().allowed));
  EXPECT_THAT(error.message, HasSubstr(GetParam().field));
}

INSTANTIATE_TEST_SUITE_P(Bad, MaterialErrors, ::testing::ValuesIn(kBadMaterials),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST(MaterialErrors, NoMaterialAtAll) {
  TestServer server;
  const Error error = server.refused(request_for(random_pairs(1), 0, 1));
  EXPECT_EQ(error.field, "material");
}

TEST(MaterialErrors, AVeryLongNameStillGetsAnAnswer) {
  TestServer server;
  v1::EvaluateRequest request = request_for(random_pairs(1), 0, 1);
  request.mutable_material()->set_model(std::string(200'000, 'x'));
  EXPECT_EQ(server.refused(request).code, ErrorCode::not_found);
  request.mutable_material()->set_name(std::string(200'000, '"'));
  request.mutable_material()->clear_model();
  EXPECT_EQ(server.refused(request).code, ErrorCode::not_found);
  v1::EvaluateRequest parameters = ggx_request(random_pairs(1));
  (*parameters.mutable_material()->mutable_parameters()->mutable_fields())[std::string(200'000,
                                                                                       '\n')];
  EXPECT_EQ(server.refused(parameters).code, ErrorCode::invalid_argument);
}

TEST(MaterialErrors, DeeplyNestedParametersAreRefused) {
  TestServer server;
  v1::EvaluateRequest request = ggx_request(random_pairs(1));
  google::protobuf::Value* value =
      &(*request.mutable_material()->mutable_parameters()->mutable_fields())["f0"];
  for (int depth = 0; depth < 500; ++depth) value = value->mutable_list_value()->add_values();
  EXPECT_EQ(server.refused(request).code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace gonio::server::testing
