#include "assess/naive_material.h"

#include <algorithm>
#include <string_view>

#include "assess/naive.h"
#include "engine/material/material_impl.h"
#include "parts/degrees.h"

namespace gonio::assess {
namespace {

// The quantities of a pair that lobes use.
template <class T>
struct Pair {
  const std::array<T, 3>&wi, &wo;
  std::array<T, 3> h;
  T hk;
};

// A lobe's checked parameters in T.
template <class T>
struct Numbers {
  const CheckedLobe& lobe;
  std::size_t channel;

  T operator()(std::string_view name) const {
    return static_cast<T>(lobe.values.colour(name, static_cast<int>(channel)));
  }
  [[nodiscard]] bool is(std::string_view parameter, std::string_view word) const {
    return word_of(lobe, parameter) == word;
  }
};

template <class T>
T reflectance(const Numbers<T>& p, T hk) {
  if (p.is("fresnel", "schlick")) return Naive<T>::schlick(p("f0"), hk);
  if (p.is("fresnel", "dielectric")) return Naive<T>::dielectric(p("eta"), hk);
  if (p.is("fresnel", "conductor")) return Naive<T>::conductor(p("eta"), p("k"), hk);
  return 1;
}

template <class T>
T lambertian(const Pair<T>&, const Numbers<T>& p) {
  return p("rd") / Naive<T>::kPi;
}

template <class T>
T oren_nayar(const Pair<T>& w, const Numbers<T>& p) {
  const T rd = p("rd");
  const auto facets = Naive<T>::oren_nayar(w.wi, w.wo, p("sigma"), p.is("form", "full"));
  return rd / Naive<T>::kPi * (facets.once + rd * facets.twice);
}

template <class T>
T ashikhmin_shirley(const Pair<T>& w, const Numbers<T>& p) {
  const T rs = p("rs");
  return p("scale") * Naive<T>::ashikhmin_shirley(w.wi, w.wo, w.h, w.hk, p("nu"), p("nv")) *
             Naive<T>::schlick(rs, w.hk) +
         p("rd") * (1 - rs) * Naive<T>::ashikhmin_shirley_diffuse(w.wi[2], w.wo[2]);
}

template <class T>
T cook_torrance(const Pair<T>& w, const Numbers<T>& p) {
  const T d = p.is("distribution", "beckmann") ? Naive<T>::beckmann(w.h, p("m"))
                                               : Naive<T>::cosine_power(w.h, p("s"));
  return p("scale") * Naive<T>::cook_torrance(w.wi, w.wo, w.h, w.hk, d) * reflectance(p, w.hk);
}

template <class T>
T ggx(const Pair<T>& w, const Numbers<T>& p) {
  return p("scale") * Naive<T>::ggx(w.wi, w.wo, w.h, p("alpha_x"), p("alpha_y")) *
         reflectance(p, w.hk);
}

template <class T>
T phong(const Pair<T>& w, const Numbers<T>& p) {
  return p("scale") * Naive<T>::phong(w.wi, w.wo, p("s")) * reflectance(p, w.hk);
}

template <class T>
T blinn_phong(const Pair<T>& w, const Numbers<T>& p) {
  return p("scale") * Naive<T>::blinn_phong(w.h, p("s")) * reflectance(p, w.hk);
}

template <class T>
T phong_mix(const Pair<T>& w, const Numbers<T>& p) {
  return p("scale") * Naive<T>::phong_mix(w.wi, w.wo, w.h, p("s"), p("mix")) * reflectance(p, w.hk);
}

template <class T>
T ward(const Pair<T>& w, const Numbers<T>& p) {
  return p("scale") * p("rs") * Naive<T>::ward(w.h, w.hk, p("alpha_x"), p("alpha_y"));
}

template <class T>
using Form = T (*)(const Pair<T>&, const Numbers<T>&);

// The models with a naive form. Others are assessed without one.
template <class T>
Form<T> form_of(std::string_view model) {
  struct Named {
    std::string_view model;
    Form<T> form;
  };
  static constexpr std::array kForms{Named{"lambertian", &lambertian<T>},
                                     Named{"oren_nayar", &oren_nayar<T>},
                                     Named{"ashikhmin_shirley", &ashikhmin_shirley<T>},
                                     Named{"cook_torrance", &cook_torrance<T>},
                                     Named{"ggx", &ggx<T>},
                                     Named{"phong", &phong<T>},
                                     Named{"blinn_phong", &blinn_phong<T>},
                                     Named{"phong_mix", &phong_mix<T>},
                                     Named{"ward", &ward<T>}};
  const auto found = std::ranges::find(kForms, model, &Named::model);
  return found == kForms.end() ? nullptr : found->form;
}

}  // namespace

template <class T>
struct NaiveMaterial<T>::Lobe {
  Form<T> form;
  std::shared_ptr<const CheckedLobe> checked;
};

template <class T>
std::optional<NaiveMaterial<T>> NaiveMaterial<T>::of(const Material& material) {
  NaiveMaterial naive;
  for (const Part& part : material.impl().parts) {
    const Form<T> form = form_of<T>(part.lobe->model->name);
    if (form == nullptr) return std::nullopt;
    naive.lobes_.push_back(std::make_shared<const Lobe>(Lobe{form, part.lobe}));
  }
  const auto turn = rotation_by(material.impl().rotation);
  naive.cos_ = static_cast<T>(turn.cos);
  naive.sin_ = static_cast<T>(turn.sin);
  return naive;
}

// In the frame of the material's tangents.
template <class T>
typename NaiveMaterial<T>::Direction NaiveMaterial<T>::seen(const Direction& w) const {
  if (sin_ == 0 && cos_ == 1) return w;
  return {cos_ * w[0] + sin_ * w[1], cos_ * w[1] - sin_ * w[0], w[2]};
}

template <class T>
void NaiveMaterial<T>::evaluate(const Direction& given_i, const Direction& given_o,
                                std::span<T> f) const {
  const Direction wi = seen(given_i), wo = seen(given_o), h = Naive<T>::half(wi, wo);
  const Pair<T> pair{wi, wo, h, Naive<T>::dot(h, wi)};
  std::ranges::fill(f, T(0));
  for (const auto& lobe : lobes_) {
    for (std::size_t c = 0; c < f.size(); ++c)
      f[c] += lobe->form(pair, Numbers<T>{*lobe->checked, c});
  }
}

template class NaiveMaterial<float>;
template class NaiveMaterial<double>;

}  // namespace gonio::assess
