#include "server/work/background_work.h"

#include <grpcpp/server_context.h>

#include <algorithm>
#include <utility>

#include "server/calls/failure.h"
#include "wire/status.h"

namespace gonio::server {

BackgroundWork::BackgroundWork(const Backend& backend, grpc::CallbackServerContext& context,
                               const char* method, const char* work)
    : backend_(backend),
      context_(context),
      work_(work),
      state_(std::min(context.deadline(), std::chrono::system_clock::now() + backend.fits.longest)),
      access_(method, "pairs", context, backend.logger) {}

Outcome BackgroundWork::submit(std::size_t bytes, std::function<void()> run,
                               std::function<void(grpc::Status)> failed) {
  charge_ = backend_.memory.take(bytes);
  BackgroundQueue::Job job{std::move(run), [this] { return is_over(); },
                           [this, failed = std::move(failed)](const std::exception_ptr& failure) {
                             failed(status_of(failure));
                           }};
  if (charge_ && backend_.fits.queue.submit(std::move(job))) return Ok{};
  const std::string full =
      charge_
          ? "queue of fits, assessments, selections and charts is full: it takes " +
                std::to_string(backend_.fits.queue.max_jobs()) + " at a time"
          : "memory is full: requests and answers hold " + std::to_string(backend_.memory.held()) +
                " of " + std::to_string(backend_.memory.limit()) + " bytes, and this one needs " +
                std::to_string(bytes);
  context_.AddTrailingMetadata(wire::kRetryPushback, kFitPushbackMilliseconds);
  return Error{
      ErrorCode::resource_exhausted,
      "the server's " + full + "; send this one again after " + kFitPushbackMilliseconds + " ms",
      {},
      {},
      {}};
}

bool BackgroundWork::should_stop() const {
  if (backend_.fits.give_way) BackgroundQueue::give_way();
  return is_over();
}

Error BackgroundWork::over() const {
  if (!state_.past_deadline()) return {ErrorCode::cancelled, work_ + " was cancelled", {}, {}, {}};
  const auto longest = std::chrono::duration_cast<std::chrono::seconds>(backend_.fits.longest);
  return {ErrorCode::deadline_exceeded,
          work_ + " was not done within its deadline; this server gives it at most " +
              std::to_string(longest.count()) + " s",
          {},
          {},
          {}};
}

Error BackgroundWork::error_of(const Error& of_the_job) const {
  return of_the_job.code == ErrorCode::cancelled ? over() : of_the_job;
}

void BackgroundWork::cancel() {
  state_.cancel();
  backend_.fits.queue.drop_over();
}

grpc::Status BackgroundWork::status_of(const std::exception_ptr& failure) const noexcept {
  return status_of_failure(access_.method, failure, backend_.logger);
}

void BackgroundWork::ended(const grpc::Status& status) noexcept {
  access_.failed = status.ok() ? 0 : 1;
  access_.write(backend_.logger, status);
}

}  // namespace gonio::server
