// Structures that travel: no field of a message is lost when it is read into its structure and
// written again, so none is on the way there or back.
#include "wire/mapping/mapping.h"

#include <gmock/gmock.h>
#include <google/protobuf/util/message_differencer.h>
#include <gtest/gtest.h>

#include <set>

#include "random_message.h"
#include "wire/mapping/assessment.h"
#include "wire/mapping/certificate.h"
#include "wire/mapping/chart_table.h"
#include "wire/mapping/selection.h"

namespace gonio::wire {

// A material as it travels: what server and client make of it is theirs.
template <>
struct Mapping<v1::Material> {
  using Message = v1::Material;
  static void write(const Message& from, Message& to) { to = from; }
  static Result<Message> read(const Message& from) { return from; }
};

namespace {

template <class Structure>
class Mapped : public ::testing::Test {};
using Structures =
    ::testing::Types<fit::Certificate, fit::Progress, select::SelectionOf<v1::Material>,
                     select::Progress, assess::Assessment, chart::Chart, chart::Progress>;
// What something else writes and reads, by the mapping's word.
template <class Structure>
void clear_elsewhere(google::protobuf::Message& message) {
  if constexpr (requires { Mapping<Structure>::kElsewhere; }) {
    for (const int number : Mapping<Structure>::kElsewhere) {
      const auto* field = message.GetDescriptor()->FindFieldByNumber(number);
      message.GetReflection()->ClearField(&message, field);
    }
  }
}

TYPED_TEST_SUITE(Mapped, Structures);

TYPED_TEST(Mapped, MessageIsTheSameAfterReadingAndWriting) {
  using Message = typename Mapping<TypeParam>::Message;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Message sent;
    RandomMessage(seed).fill(sent);
    clear_elsewhere<TypeParam>(sent);
    const auto read = from_message<TypeParam>(sent);
    ASSERT_TRUE(read) << read.error().message;
    const Message again = to_message(*read);
    std::string difference;
    google::protobuf::util::MessageDifferencer differ;
    differ.ReportDifferencesToString(&difference);
    EXPECT_TRUE(differ.Compare(sent, again)) << difference;
  }
}

// What is not given gets a default, once.
TYPED_TEST(Mapped, EmptyMessageIsReadAsDefaults) {
  using Message = typename Mapping<TypeParam>::Message;
  const auto read = from_message<TypeParam>(Message{});
  ASSERT_TRUE(read) << read.error().message;
  const Message again = to_message(*read);
  const auto second = from_message<TypeParam>(again);
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(to_message(*second).SerializeAsString(), again.SerializeAsString());
}

struct Three {
  double one = 0;
  std::optional<std::string> two;
  std::array<double, 3> three{};
};
template <class... Fields>
concept IsAList = requires(Fields... all) {
  fields<Three>(all...);
};
using One = MappedField<Three, double>;
using Two = MappedField<Three, std::optional<std::string>>;
using Last = MappedField<Three, std::array<double, 3>>;
static_assert(IsAList<One, Two, Last>);
static_assert(!IsAList<One, Two>, "a member that is not listed must not compile");

TEST(Mapping, WordsOfANewerServerAreNoOthers) {
  v1::FitCertificate sent;
  sent.set_verdict(static_cast<v1::FitVerdict>(v1::FitVerdict_MAX + 1));
  sent.set_objective(static_cast<v1::FitObjective>(v1::FitObjective_MAX + 1));
  const auto read = from_message<fit::Certificate>(sent);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->verdict, fit::Verdict::unknown);
  EXPECT_FALSE(read->objective);
}

TEST(Mapping, CorrelationIsGivenOrNot) {
  const auto without = from_message<fit::Indistinct>(to_message(fit::Indistinct{}));
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->correlation);
  const auto zero = from_message<fit::Indistinct>(to_message(fit::Indistinct{{}, 1, 0.0}));
  ASSERT_TRUE(zero);
  EXPECT_EQ(zero->correlation, 0.0);
}

// A direction of a broken server, with too many or too few numbers.
TEST(Mapping, DirectionsHaveThreeNumbers) {
  v1::FitPlace sent;
  for (const double x : {1.0, 2.0, 3.0, 4.0}) sent.add_wi(x);
  sent.add_wo(5);
  const auto read = from_message<fit::Place>(sent);
  ASSERT_TRUE(read);
  EXPECT_THAT(read->wi, ::testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(read->wo, ::testing::ElementsAre(5, 0, 0));
}

}  // namespace
}  // namespace gonio::wire
