#include "server/logging.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include "gonio/base/shown.h"

namespace gonio::server {
namespace {

template <class Formatter>
std::string formatted_by(const std::string& text) {
  spdlog::memory_buf_t out;
  Formatter().format(spdlog::details::log_msg("goniod", spdlog::level::warn, text), out);
  return {out.data(), out.size()};
}
std::string formatted(const std::string& text) { return formatted_by<JsonFormatter>(text); }

google::protobuf::Struct parsed(const std::string& line) {
  google::protobuf::Struct object;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(line, &object).ok()) << line;
  return object;
}

// What a header, a file's name or a parameter's name may hold.
const std::string& foreign() {
  static const std::string kText = [] {
    std::string text;
    for (int c = 0; c < 256; ++c) text.push_back(static_cast<char>(c));
    return text +
           "\n2024-01-31 12:00:00.000 info forged\n\x1b[2J \xE2\x80\xAE \xED\xA0\x80 \xC3\xA9";
  }();
  return kText;
}

TEST(JsonLog, HoldsTheMessageAsItIsShown) {
  const std::string line = formatted(foreign());
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const auto object = parsed(line);
  EXPECT_EQ(object.fields().at("message").string_value(), shown(foreign()));
  EXPECT_EQ(object.fields().at("level").string_value(), "warning");
  EXPECT_EQ(object.fields().at("time").string_value().size(),
            std::string("2024-01-31T12:00:00.000Z").size());
}

TEST(TextLog, HoldsTheMessageAsItIsShownOnOneLine) {
  const std::string line = formatted_by<TextFormatter>(foreign());
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_EQ(line.substr(line.find(" warning ")), " warning " + shown(foreign()) + "\n");
  EXPECT_EQ(line.find(" warning "), std::string("2024-01-31 12:00:00.000").size());
}

TEST(Log, AMessageWithoutEndIsCut) {
  const std::string line = formatted_by<TextFormatter>(std::string(1 << 20, 'x'));
  EXPECT_LT(line.size(), 10'000U);
  EXPECT_EQ(line.substr(line.size() - 4), "...\n");
}

}  // namespace
}  // namespace gonio::server
