#include "server/logging.h"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

namespace gonio {
namespace {

std::string formatted(const std::string& text) {
  spdlog::memory_buf_t out;
  JsonFormatter().format(spdlog::details::log_msg("goniod", spdlog::level::warn, text), out);
  return {out.data(), out.size()};
}

google::protobuf::Struct parsed(const std::string& line) {
  google::protobuf::Struct object;
  EXPECT_TRUE(google::protobuf::util::JsonStringToMessage(line, &object).ok()) << line;
  return object;
}

TEST(JsonLog, EveryCharacterSurvives) {
  std::string text;
  for (char c = 1; c < 127; ++c) text.push_back(c);
  text += "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80";
  const std::string line = formatted(text);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  const auto object = parsed(line);
  EXPECT_EQ(object.fields().at("message").string_value(), text);
  EXPECT_EQ(object.fields().at("level").string_value(), "warning");
  EXPECT_EQ(object.fields().at("time").string_value().size(),
            std::string("2024-01-31T12:00:00.000Z").size());
}

TEST(JsonLog, BytesThatAreNotUtf8AreReplaced) {
  for (const std::string bytes :
       {"\xff", "\xC3", "\xE2\x82", "\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80"}) {
    const auto object = parsed(formatted("a" + bytes + "b"));
    const std::string message = object.fields().at("message").string_value();
    EXPECT_EQ(message.substr(0, 4), "a\xEF\xBF\xBD");
    EXPECT_EQ(message.back(), 'b');
  }
}

TEST(JsonLog, NulByte) {
  EXPECT_EQ(parsed(formatted(std::string(1, '\0'))).fields().at("message").string_value().size(),
            1U);
}

}  // namespace
}  // namespace gonio
