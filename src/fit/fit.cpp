#include "fit/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "fit/data/outliers.h"
#include "fit/data/unit.h"
#include "fit/report/certify.h"
#include "fit/search/rotation.h"
#include "fit/search/search.h"

namespace gonio::fit {
namespace {

constexpr double kRightAngle = 1.5707963267948966;

Outcome check(const Options& options) {
  const auto number = [](double x) { return std::to_string(x); };
  if (!(options.min_theta >= 0 && options.min_theta < options.max_theta))
    return bad_value("options.min_theta", number(options.min_theta),
                     "0 to below max_theta, in radians");
  if (!(options.max_theta <= kRightAngle + 1e-9))
    return bad_value("options.max_theta", number(options.max_theta), "at most pi/2, in radians");
  if (!(options.huber > 0) || !std::isfinite(options.huber))
    return bad_value("options.huber", number(options.huber), "above 0");
  if (options.starts < 1 || options.starts > 100)
    return bad_value("options.starts", std::to_string(options.starts), "1 to 100");
  if (options.scan_pairs < 1 || options.fit_pairs < 1)
    return bad_value("options.fit_pairs and scan_pairs", "0", "at least 1");
  return Ok{};
}

// Huber's threshold in the residual's unit.
double threshold_of(const Data& data, const Options& options) {
  if (options.objective != Objective::huber) return 1;
  const double mean = mean_of(data, options.cosine);
  return mean > 0 ? options.huber * mean : options.huber;
}

Outcome not_stopped(const Watch& watch) {
  if (!watch.stop || !watch.stop()) return Ok{};
  return Error{ErrorCode::cancelled, "the fit was cancelled", {}, {}, {}};
}

// First with the tangents along the frame's axes, or as given. Then, if the rotation is free and
// fitting it lowers the objective, with that rotation.
Result<FitResult> fit_and_certify(const SearchInput& input, const Data& data,
                                  const MaterialSpec& spec) {
  const bool staged = input.options.strategy == Strategy::staged;
  Search search = staged ? search_staged(input) : search_automatic(input);
  const bool free = input.options.anisotropic && !staged && !spec.rotation;
  const Form form = with_shapes(input.form, *make_form(spec, {input.options.anisotropic, free}));
  const SearchInput turned{form, input.data, input.options, input.watch, input.loss};
  std::optional<Search> found;
  if (form.rotation_shape) found = search_turned(input, turned, search);
  if (auto ok = not_stopped(input.watch); !ok) return ok.error();
  if (search.parameters.empty())
    return Error{ErrorCode::internal, "the fit found no finite objective", {}, {}, {}};
  if (found) return certify(turned, data, std::move(*found));
  const std::vector<double> aligned = search.parameters;
  FitResult result = certify(input, data, std::move(search));
  if (form.rotation_shape) {
    add_aligned(turned, aligned, result.certificate);
  } else if (input.options.hints) {
    add_hint(input, spec, aligned, result.certificate);
  }
  // What stopped on the way has left the certificate unfinished.
  if (auto ok = not_stopped(input.watch); !ok) return ok.error();
  return result;
}

}  // namespace

Result<FitResult> fit(const Data& data, const MaterialSpec& spec, const Options& options,
                      const Watch& watch) {
  const double begin = cpu_seconds();
  if (auto ok = check(options); !ok) return ok.error();
  auto form = make_form(spec, {options.anisotropic});
  if (!form) return form.error();
  const bool whole = options.min_theta <= 0 && options.max_theta >= kRightAngle;
  const Data zone = whole ? Data{} : within(data, options.min_theta, options.max_theta);
  const Data& chosen = whole ? data : zone;
  if (auto ok = check_size(chosen); !ok) return ok.error();
  form->unit = unit_of(chosen, options.cosine);
  const Data scaled = form->unit == 1 ? Data{} : in_unit(chosen, form->unit);
  const Data& fitted = form->unit == 1 ? chosen : scaled;
  const Loss loss{options.objective, 0, threshold_of(fitted, options)};
  const SearchInput input{*form, fitted, options, watch, loss};
  if (fitted.size() == 0) return nothing_to_fit(data, options);
  auto result = fit_and_certify(input, data, spec);
  if (!result) return result.error();
  judge_outliers(chosen, result->certificate);
  result->certificate.cpu_seconds = cpu_seconds() - begin;
  return result;
}

}  // namespace gonio::fit
