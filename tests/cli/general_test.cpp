// The tool as a whole: help, version, exit codes, the list of models, where the server is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"
#include "cli/support/socket_server.h"
#include "gonio/base/version.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string kLambertian =
    R"( --material '{"model": "lambertian", "parameters": {"rd": [0.5, 0.25]}}' )";
const std::string kNormal = " --grid theta_i=0 ";

TEST(Tool, VersionAndHelp) {
  EXPECT_EQ(shell("gonio --version").out, std::string("gonio ") + kVersion + "\n");
  const auto help = shell("gonio --help");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("Examples:"), HasSubstr("evaluate"), HasSubstr("models"),
                              HasSubstr("Exit status")));
  EXPECT_THAT(help.err, IsEmpty());
  const auto evaluate = shell("gonio evaluate --help");
  EXPECT_EQ(evaluate.exit_code, 0);
  for (const char* option : {"--material", "--pairs", "--grid", "--precision", "--deg", "--format",
                             "--output", "--server", "--deadline", "--isa", "theta_i=0:80:9"}) {
    EXPECT_THAT(evaluate.out, HasSubstr(option));
  }
}

TEST(Tool, WrongArgumentsExitWithTwo) {
  for (const char* line :
       {"gonio", "gonio nonsense", "gonio evaluate", "gonio models a b c",
        "gonio evaluate --material x", "gonio evaluate --material x --pairs a --grid b",
        "gonio evaluate --material x --grid theta_i=0 --precision exact",
        "gonio evaluate --material x --grid theta_i=0 --format xml",
        "gonio evaluate --material x --grid theta_i=0 --isa mmx",
        "gonio evaluate --material x --grid theta_i=0 --threads -3",
        "gonio evaluate --material x --grid theta_i=0 --deadline soon"}) {
    const auto result = shell(line);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_THAT(result.out, IsEmpty()) << line;
    EXPECT_THAT(result.err, StartsWith("gonio: error: ")) << line;
  }
}

TEST(Models, TablePageAndJson) {
  const auto table = shell("gonio models");
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_THAT(table.err, IsEmpty());
  EXPECT_THAT(table.out, AllOf(HasSubstr("lambertian"), HasSubstr("ggx"), HasSubstr("baseline")));

  const auto page = shell("gonio models ggx");
  EXPECT_EQ(page.exit_code, 0);
  EXPECT_THAT(page.out, AllOf(HasSubstr("Parameters"), HasSubstr("alpha_x"), HasSubstr("Source"),
                              HasSubstr("relative error"), HasSubstr("Example")));

  const auto json = shell("gonio models ggx --json");
  EXPECT_EQ(json.exit_code, 0);
  EXPECT_THAT(json.out,
              AllOf(StartsWith("{"), HasSubstr("\"name\": \"ggx\""), HasSubstr("\"upper\"")));

  const auto wrong = shell("gonio models gggx");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.out, IsEmpty());
  EXPECT_THAT(wrong.err, AllOf(StartsWith("gonio: error: "), HasSubstr("gggx")));
}

// What a page prints as its example must work as it stands.
TEST(Models, ExamplesOnThePagesRun) {
  for (const char* model : {"lambertian", "ashikhmin_shirley", "cook_torrance", "ggx"}) {
    const auto page = shell(std::string("gonio models ") + model).out;
    const auto command = page.substr(page.rfind("gonio evaluate"));
    const auto result = shell(command);
    EXPECT_EQ(result.exit_code, 0) << command << result.err;
    EXPECT_EQ(lines_of(result.out).size(), 10U) << command;
  }
}

class WithServer : public ::testing::Test {
 protected:
  gonio::testing::TempFolder folder_;
  SocketServer server_{{{"grey", R"({"model": "lambertian", "parameters": {"rd": 0.5}})"}}};
  std::string address_ = server_.address();
};

TEST_F(WithServer, GivesTheSameAsTheEmbeddedOne) {
  const std::string command =
      "gonio evaluate" + kLambertian + "--grid theta_i=0:1.5:40,theta_o=0:1.5:50 ";
  const auto embedded = shell(command);
  const auto option = shell(command + "--server " + address_);
  const auto environment = shell("export GONIO_SERVER=" + address_ + "; " + command);
  EXPECT_EQ(embedded.exit_code, 0) << embedded.err;
  EXPECT_EQ(lines_of(embedded.out).size(), 2001U);
  EXPECT_EQ(option.out, embedded.out) << option.err;
  EXPECT_EQ(environment.out, embedded.out) << environment.err;
}

TEST_F(WithServer, HasStoredMaterials) {
  const std::string command = "gonio evaluate --material grey" + kNormal;
  const auto known = shell(command + "--server " + address_);
  EXPECT_EQ(known.exit_code, 0) << known.err;
  EXPECT_EQ(known.out, "f_0,flags\n0.159154937,0\n");
  EXPECT_THAT(shell("gonio models --server " + address_).out, HasSubstr("Stored materials: grey"));
  const auto unknown = shell(command);  // the embedded server holds none
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("grey"));
}

TEST_F(WithServer, MeasuredFilesAreForTheEmbeddedOneAlone) {
  write_file(folder_ / "short.binary", "123");
  const std::string file = folder_ / "short.binary";
  const auto remote = shell("gonio evaluate --material " + file + kNormal + "--server " + address_);
  EXPECT_EQ(remote.exit_code, 2);
  EXPECT_THAT(remote.err, AllOf(HasSubstr("short.binary"), HasSubstr("--server")));
  const auto embedded = shell("gonio evaluate --material " + file + kNormal);
  EXPECT_EQ(embedded.exit_code, 2);  // it is read, and found to be no MERL file
  EXPECT_THAT(embedded.err, HasSubstr("short.binary"));
}

TEST(Tool, AnAddressWithoutAPortIsAWrongArgument) {
  const auto result = shell("gonio models --server localhost");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, AllOf(HasSubstr("--server is \"localhost\""), HasSubstr("host:port")));
}

TEST(Unreachable, ExitsWithThreeAndNamesTheAddress) {
  for (const char* command : {"gonio models", "gonio evaluate --material grey --grid theta_i=0"}) {
    const auto result = shell(std::string(command) + " --server 127.0.0.1:1");
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, AllOf(StartsWith("gonio: error: "), HasSubstr("127.0.0.1:1")));
  }
}

TEST(Unreachable, DeadlineExitsWithThree) {
  const gonio::testing::TempFolder folder;
  const std::string out = folder / "out.npy";
  const auto result =
      shell("gonio evaluate" + kLambertian +
            "--grid theta_i=0:1.5:1000,theta_o=0:1.5:1000,phi_o=0:6:1000 --deadline 0.2 -o " + out);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("deadline"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(shell("ls -A " + std::filesystem::path(out).parent_path().string()).out, "");
}

}  // namespace
}  // namespace gonio::test
