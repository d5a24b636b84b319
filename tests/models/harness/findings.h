// Collecting what checks find.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "models/oracle/pairs.h"

namespace gonio::testing {

class Notes {
 public:
  // Enough to tell a person where to look.
  [[nodiscard]] bool full() const { return findings_.size() >= 5; }
  void add(std::string finding) {
    if (!full()) findings_.push_back(std::move(finding));
  }

  // Two values that should agree, at a pair and a channel.
  template <class T>
  void add(const std::string& what, const DirectionPair<T>& pair, std::size_t channel, double got,
           double want) {
    std::ostringstream text;
    text << std::setprecision(17) << what << ", " << name_of(pair.kind) << ", channel " << channel
         << ": " << got << " and " << want << " at wi";
    for (const auto& w : {pair.wi, pair.wo}) {
      for (const T component : w) text << ' ' << component;
      text << (&w == &pair.wi ? ", wo" : "");
    }
    add(text.str());
  }

  [[nodiscard]] const std::vector<std::string>& findings() const { return findings_; }

 private:
  std::vector<std::string> findings_;
};

}  // namespace gonio::testing
