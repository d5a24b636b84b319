// A plain client of the streaming calls: sends all chunks, collects all answers by sequence number.
#pragma once

#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "server/support/harness.h"

namespace gonio::server::testing {

template <class Answer>
struct StreamResultOf {
  grpc::Status status;
  std::map<std::uint64_t, Answer> answers;
};
using StreamResult = StreamResultOf<v1::EvaluateStreamResponse>;

// On a call that has just begun.
template <class Chunk, class Answer>
StreamResultOf<Answer> exchange(grpc::ClientReaderWriter<Chunk, Answer>& call,
                                const std::vector<Chunk>& chunks) {
  // Written from another thread: with flow control, a client that does not read cannot write for
  // ever.
  std::thread writer([&] {
    for (const auto& chunk : chunks) {
      if (!call.Write(chunk)) break;
    }
    call.WritesDone();
  });
  StreamResultOf<Answer> result;
  for (Answer answer; call.Read(&answer);) {
    const std::uint64_t sequence = answer.sequence();
    EXPECT_TRUE(result.answers.emplace(sequence, std::move(answer)).second)
        << sequence << " was answered twice";
  }
  writer.join();
  result.status = call.Finish();
  return result;
}

inline StreamResult stream(v1::GonioService::Stub& stub,
                           const std::vector<v1::EvaluateStreamRequest>& chunks) {
  grpc::ClientContext context;
  return exchange(*stub.EvaluateStream(&context), chunks);
}

// `pairs` in chunks of `size`, the material with the first.
inline std::vector<v1::EvaluateStreamRequest> chunked(const PairArrays& pairs, std::size_t size,
                                                      double alpha = 0.2) {
  std::vector<v1::EvaluateStreamRequest> chunks;
  for (std::size_t first = 0; first < pairs.size(); first += size) {
    v1::EvaluateStreamRequest chunk;
    chunk.set_sequence(chunks.size());
    *chunk.mutable_evaluate() = request_for(pairs, first, std::min(size, pairs.size() - first));
    if (first == 0) set_ggx(*chunk.mutable_evaluate()->mutable_material(), alpha);
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

inline std::vector<float> joined(const StreamResult& result) {
  std::vector<float> values;
  for (const auto& [sequence, answer] : result.answers) {
    EXPECT_TRUE(answer.has_evaluate()) << answer.error().message();
    values.insert(values.end(), answer.evaluate().values().begin(),
                  answer.evaluate().values().end());
  }
  return values;
}

}  // namespace gonio::server::testing
