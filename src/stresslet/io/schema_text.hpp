#pragma once
/// Text made from a described struct: resolved input, commented template, Markdown reference.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stresslet/io/schema.hpp"

namespace stresslet {

struct DescribedKey {
  KeyInfo info;
  std::string_view type;                    ///< completes "must be ..."
  std::optional<InputValue> value;          ///< none: not given
  std::optional<InputValue> default_value;  ///< none: required, or see info.presence.otherwise
};

struct DescribedSection {
  std::string path;
  std::string_view doc;
  bool optional = false;
  bool given = true;
  std::vector<DescribedKey> keys;
};

/// Collects sections and keys with their values, in the order of description.
class SectionDescriber : public SectionPath {
 public:
  template <class T>
  void key(std::string_view name, T& member, Presence presence, Check check, std::string_view unit,
           std::string_view doc) {
    if constexpr (IsOptional<T>::value) {
      using Type = InputType<typename T::value_type>;
      add({{path_of(name), presence, completed<typename T::value_type>(std::move(check)), unit, doc},
           Type::name,
           member ? std::optional(Type::write(*member)) : std::nullopt,
           std::nullopt});
    } else {
      add({{path_of(name), presence, completed<T>(std::move(check)), unit, doc},
           InputType<T>::name,
           InputType<T>::write(member),
           std::nullopt});
    }
  }

  template <class S>
  void section(std::string_view name, S& member, std::string_view doc) {
    const std::size_t outer = current_;
    current_ = sections_.size();
    if constexpr (IsOptional<S>::value) {
      sections_.push_back({path_of(name), doc, true, member.has_value(), {}});
      typename S::value_type content = member.value_or(typename S::value_type());
      inside(name, [&] { content.describe(*this); });
    } else {
      sections_.push_back({path_of(name), doc, false, true, {}});
      inside(name, [&] { member.describe(*this); });
    }
    current_ = outer;
  }

  std::vector<DescribedSection> take() { return std::move(sections_); }

 private:
  void add(DescribedKey key) {
    if (sections_.empty()) sections_.emplace_back();
    sections_[current_].keys.push_back(std::move(key));
  }

  std::vector<DescribedSection> sections_;
  std::size_t current_ = 0;
};

/// Copies the values of a freshly made struct into the defaults of the keys that have one.
void set_defaults(std::vector<DescribedSection>& sections, const std::vector<DescribedSection>& fresh);

template <class S>
std::vector<DescribedSection> described(S value) {
  SectionDescriber describer, fresh;
  value.describe(describer);
  S().describe(fresh);
  std::vector<DescribedSection> sections = describer.take();
  set_defaults(sections, fresh.take());
  return sections;
}

/// Every key with its value; keys and sections that are not given stand in comments. Reads back to an equal struct.
std::string resolved_text(const std::vector<DescribedSection>& sections);

/// Every key with its documentation; those at their default are commented out.
std::string template_text(const std::vector<DescribedSection>& sections);

/// One heading and one table per section.
std::string markdown_text(const std::vector<DescribedSection>& sections);

}  // namespace stresslet
