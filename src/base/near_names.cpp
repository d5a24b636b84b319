#include "base/near_names.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "base/text/join.h"
#include "gonio/base/shown.h"

namespace gonio {
namespace {

// The distance takes quadratic time, and names come from outside.
constexpr std::size_t kMaxCompared = 64;
constexpr std::size_t kMaxListed = 5;
constexpr std::size_t kShort = 3;  // characters; two edits of so short a name leave nothing of it

std::string folded(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, kMaxCompared)) {
    if (c == '-' || c == '_' || c == ' ') continue;
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return result;
}

// The restricted distance of Damerau and Levenshtein, row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

// The distance of two names. 0: the same; above limit_of(): not alike.
std::size_t unlikeness(const std::string& name, const std::string& candidate) {
  const std::size_t distance = edit_distance(name, candidate);
  const bool within =
      std::min(name.size(), candidate.size()) >= kShort &&
      (candidate.find(name) != std::string::npos || name.find(candidate) != std::string::npos);
  return within ? std::min<std::size_t>(distance, 1) : distance;
}

std::size_t limit_of(const std::string& name) {
  if (name.size() <= kShort) return name.empty() ? 0 : 1;
  return std::max<std::size_t>(2, name.size() / 3);
}

// The candidates within the limit, best first; of equal ones that of nearer length, then in their
// order. A single character is like no other: one edit replaces all of it.
template <class Text>
std::vector<std::string> all_alike(std::string_view name, std::span<const Text> candidates) {
  struct Alike {
    std::size_t distance, longer;
    std::string name;
  };
  const std::string wanted = folded(name);
  std::vector<Alike> alike;
  for (const Text& candidate : candidates) {
    const std::string other = folded(candidate);
    const std::size_t distance = unlikeness(wanted, other);
    const std::size_t longest = std::max(wanted.size(), other.size());
    if (distance > limit_of(wanted) || (distance > 0 && distance >= longest)) continue;
    const std::size_t shortest = std::min(wanted.size(), other.size());
    alike.push_back({distance, longest - shortest, std::string(candidate)});
  }
  std::stable_sort(alike.begin(), alike.end(), [](const Alike& a, const Alike& b) {
    return std::pair(a.distance, a.longer) < std::pair(b.distance, b.longer);
  });
  std::vector<std::string> names;
  for (Alike& one : alike) names.push_back(std::move(one.name));
  return names;
}

template <class Text>
std::optional<std::string> nearest(std::string_view name, std::span<const Text> candidates) {
  std::vector<std::string> alike = all_alike(name, candidates);
  if (alike.empty()) return std::nullopt;
  return std::move(alike.front());
}

template <class Text>
std::string question(std::string_view name, std::span<const Text> candidates) {
  const auto meant = nearest(name, candidates);
  return meant ? "; did you mean \"" + shown(*meant, kQuotedLength) + "\"?" : std::string();
}

template <class Text>
Error unknown(std::string_view field, std::string_view given, std::span<const Text> known,
              ErrorCode code) {
  return bad_value(field, '"' + std::string(given) + '"', joined(known) + question(given, known),
                   code);
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name,
                                        std::span<const std::string_view> candidates) {
  return nearest(name, candidates);
}

std::optional<std::string> nearest_name(std::string_view name,
                                        std::span<const std::string> candidates) {
  return nearest(name, candidates);
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> candidates) {
  return question(name, candidates);
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  return question(name, candidates);
}

Error unknown_word(std::string_view field, std::string_view given,
                   std::span<const std::string_view> known, ErrorCode code) {
  return unknown(field, given, known, code);
}

Error unknown_word(std::string_view field, std::string_view given,
                   std::span<const std::string> known, ErrorCode code) {
  return unknown(field, given, known, code);
}

std::string near_names(std::string_view name, std::span<const std::string> candidates) {
  if (candidates.empty()) return "none";
  const std::vector<std::string> alike = all_alike(name, candidates);
  const std::span<const std::string> listed(alike);
  if (!alike.empty()) return joined(listed.first(std::min(listed.size(), kMaxListed)));
  if (candidates.size() <= kMaxListed) return joined(candidates);
  return joined(candidates.first(kMaxListed)) + " and " +
         std::to_string(candidates.size() - kMaxListed) + " more";
}

}  // namespace gonio
