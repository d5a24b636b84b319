// `gonio put` as users see it, on a server of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/support/run_process.h"
#include "cli/support/socket_server.h"
#include "measured/synthetic_merl.h"

namespace gonio::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A server with a folder, a MERL file in $D/grey.binary, and shell lines with both.
class PutCommand : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    files_ = std::make_unique<gonio::testing::TempFolder>();
    const auto grey = [](double theta_h, double, double) {
      return theta_h < 1 ? gonio::testing::Rgb{0.1, 0.05, 0.025} : gonio::testing::Rgb{-1, 1, 1};
    };
    ASSERT_TRUE(gonio::testing::write_merl(*files_ / "grey.binary", grey));
  }
  static void TearDownTestSuite() { files_.reset(); }

  [[nodiscard]] Finished run(const std::string& line) const {
    return shell("D='" + (*files_ / "").string() + "'; export GONIO_SERVER='" + server_.address() +
                 "'; " + line);
  }

  static inline std::unique_ptr<gonio::testing::TempFolder> files_;
  gonio::testing::TempFolder folder_;
  SocketServer server_;
};

TEST_F(PutCommand, StoresAMaterialThatIsThenUsedByName) {
  const auto put = run("gonio put grey $D/grey.binary");
  ASSERT_EQ(put.exit_code, 0) << put.err;
  EXPECT_THAT(put.out, AllOf(HasSubstr("grey: stored in the server's materials folder"),
                             HasSubstr("1458000 cells"), HasSubstr("sha256 ")));
  EXPECT_EQ(read_file(server_.folder() / "grey.binary"), read_file(*files_ / "grey.binary"));
  EXPECT_THAT(run("gonio put grey $D/grey.binary").out, HasSubstr("was there already"));
  EXPECT_THAT(run("gonio put -q grey $D/grey.binary").out, IsEmpty());
  const auto values = run("gonio evaluate -m grey --grid theta_i=10,theta_o=20 --deg");
  EXPECT_THAT(values.out, HasSubstr("0.1")) << values.err;
  const auto fit = run("gonio fit --data grey --model lambertian");
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_THAT(fit.out, AllOf(HasSubstr("negative or not measured"), HasSubstr("rd 0.3142 +-")));
  EXPECT_THAT(run("gonio fit --data gray --model lambertian").err,
              AllOf(HasSubstr("measured.name"), HasSubstr("grey")));
}

TEST_F(PutCommand, NamesWhatIsWrong) {
  const auto error_of = [&](const std::string& arguments, int exit_code = 2) {
    const auto result = run("gonio put " + arguments);
    EXPECT_EQ(result.exit_code, exit_code) << arguments;
    EXPECT_THAT(result.out, IsEmpty());
    return result.err;
  };
  EXPECT_THAT(error_of("../up $D/grey.binary"), HasSubstr("allowed: 1 to 100 letters"));
  EXPECT_THAT(error_of("grey $D/none.binary"), HasSubstr("no such file"));
  EXPECT_THAT(error_of("grey $D"), HasSubstr("a folder"));
  write_file(folder_ / "short.binary", "short");
  EXPECT_THAT(error_of("grey '" + (folder_ / "short.binary").string() + "'"),
              HasSubstr("found 5 bytes; expected a MERL .binary file of 34992012 bytes"));
  write_file(folder_ / "other.binary", std::string(34992012, 'x'));
  EXPECT_THAT(error_of("grey '" + (folder_ / "other.binary").string() + "'"),
              HasSubstr("the dimensions"));
  write_file(server_.folder() / "late.json", "{}");
  EXPECT_THAT(error_of("late $D/grey.binary"), HasSubstr("materials folder has a file"));
  EXPECT_THAT(error_of("--server unix:/no/such grey $D/grey.binary", 3), HasSubstr("/no/such"));
  const auto alone = shell("gonio put grey x.binary");
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, HasSubstr("--server is not given"));
}

}  // namespace
}  // namespace gonio::test
