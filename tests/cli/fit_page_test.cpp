// The page of a fit: what the certificate holds is on it.
#include "client/cli/report/fit_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gonio::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string page_of(const client::FitCertificate& certificate) {
  return fit_page({{"ggx", {client::Material::model("ggx"), certificate, {}}}}, {});
}

TEST(FitPage, SaysWhatWasMinimised) {
  client::FitCertificate certificate;
  certificate.objective = client::Objective::huber;
  EXPECT_THAT(page_of(certificate),
              HasSubstr("How it was found, minimising huber (objectives as parts of"));
  certificate.objective.reset();  // of a newer server
  EXPECT_THAT(page_of(certificate), HasSubstr("How it was found (objectives as parts of"));
}

TEST(FitPage, SaysTheCorrelationOfTwoNumbers) {
  client::FitCertificate certificate;
  certificate.indistinct = {{{"f0", "alpha_x"}, 0.002, -0.998}};
  EXPECT_THAT(page_of(certificate), HasSubstr("The data hardly tell apart: f0, alpha_x "
                                              "(eigenvalue 0.002, correlation -0.998)."));
  certificate.indistinct = {{{"f0", "alpha_x"}, 0.002, {}}};
  EXPECT_THAT(page_of(certificate), HasSubstr("alpha_x (eigenvalue 0.002)."));
  EXPECT_THAT(page_of(certificate), Not(HasSubstr("correlation -")));
}

}  // namespace
}  // namespace gonio::cli
