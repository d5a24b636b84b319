#include "server/calls/call.h"

#include <grpcpp/server_context.h>
#include <spdlog/spdlog.h>

#include <utility>

namespace gonio::server {

namespace {

Error busy(const std::string& what) {
  return {ErrorCode::resource_exhausted,
          "the server's " + what + "; send this one again after " + kPushbackMilliseconds + " ms",
          "", "", ""};
}

}  // namespace

Outcome compute(const Backend& backend, const std::shared_ptr<Work>& work, const CallState& state,
                WorkEnd end) {
  auto charge = backend.memory.take(work->bytes());
  if (!charge) {
    return busy("memory is full: requests and answers hold " +
                std::to_string(backend.memory.held()) + " of " +
                std::to_string(backend.memory.limit()) + " bytes");
  }
  work->keep(std::move(charge));
  if (work->is_small()) {
    work->run_all();
    end.done(true);
    return Ok{};
  }
  ThreadPool::Job job;
  job.tiles = work->tiles();
  job.run = [work](std::size_t tile) { work->run_tile(tile); };
  job.stop = [&state] { return state.is_over(); };
  job.done = std::move(end.done);
  job.failed = std::move(end.failed);
  if (backend.pool.submit(std::move(job))) return Ok{};
  return busy("queue is full: it holds at most " + std::to_string(backend.max_queued_jobs) +
              " batches");
}

AccessLine::AccessLine(const char* method_name, const char* name_of_items,
                       const grpc::CallbackServerContext& context, const spdlog::logger& logger)
    : method(method_name),
      items_name(name_of_items),
      peer(logger.should_log(spdlog::level::debug) ? context.peer() : "") {}

void AccessLine::write(spdlog::logger& logger, const grpc::Status& status) const noexcept try {
  if (!logger.should_log(spdlog::level::debug)) return;
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  const std::string outcome = status.ok() ? "OK" : status.error_message();
  logger.debug("{} from {}: {}, {:.3f} ms, {} batches ({} failed), {} {}, kernels {:.3f} ms",
               method, peer, outcome, taken.count(), batches, failed, items, items_name,
               1e3 * kernel_seconds);
} catch (...) {
  return;  // no memory for it
}

}  // namespace gonio::server
