#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/extended_xyz.hpp"
#include "stresslet/io/number_text.hpp"

namespace stresslet {
namespace {

struct Property {
  std::string name;
  char type;
  std::size_t first, count;  // words of a line
};

class FrameReader {
 public:
  FrameReader(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {}

  bool at_end() const { return trimmed_all(rest_).empty(); }

  /// Reads the next frame, or only steps over it.
  XyzFrame frame(bool skip) {
    const std::string_view count_text = trimmed(next_line());
    const auto count = number<std::int64_t>(count_text);
    if (!count || *count < 1)
      refuse(fmt::format("'{}' is no number of particles", count_text), "every frame begins with it");
    XyzFrame frame;
    const auto keys = comment_keys(next_line());
    if (!skip) read_comment(keys, frame);
    frame.first_line = line_ + 1;
    for (std::int64_t i = 0; i < *count; ++i) {
      if (at_end()) refuse(fmt::format("the file ends after {} of {} particles", i, *count), "the frame is cut short");
      const std::string_view line = next_line();
      if (!skip) read_particle(line, frame);
    }
    return frame;
  }

 private:
  static std::string_view trimmed_all(std::string_view text) {
    const auto begin = text.find_first_not_of(" \t\r\n");
    return begin == std::string_view::npos ? std::string_view{} : text.substr(begin);
  }

  [[noreturn]] void refuse(const std::string& problem, const std::string& reason) const {
    throw InputError({fmt::format("{}:{}", file_, line_), problem, reason,
                      "write extended XYZ: a line with the number of particles, a line with Lattice=\"...\" and "
                      "Properties=..., one line per particle"});
  }

  std::string_view next_line() {
    ++line_;
    return take_line(rest_);
  }

  std::map<std::string, std::string> comment_keys(std::string_view line) const {
    std::map<std::string, std::string> keys;
    while (!(line = trimmed(line)).empty()) {
      const std::size_t key_end = line.find_first_of("= \t");
      const std::string key(line.substr(0, key_end));
      if (key_end == std::string_view::npos || line[key_end] != '=') {
        line.remove_prefix(key.size());
        continue;
      }
      line.remove_prefix(key_end + 1);
      const bool quoted = line.starts_with('"');
      if (quoted) line.remove_prefix(1);
      const std::size_t end = quoted ? line.find('"') : line.find_first_of(" \t");
      if (quoted && end == std::string_view::npos) refuse("the quotation mark after " + key + "= is not closed", "");
      keys[key] = line.substr(0, end);
      line.remove_prefix(std::min(line.size(), end == std::string_view::npos ? end : end + 1));
    }
    return keys;
  }

  void read_comment(const std::map<std::string, std::string>& keys, XyzFrame& frame) {
    const auto find = [&](const char* key) {
      const auto found = keys.find(key);
      return found == keys.end() ? std::string_view{} : std::string_view(found->second);
    };
    frame.strain = number(find("strain"));
    frame.time = number(find("time"));
    if (const std::string_view lattice = find("Lattice"); !lattice.empty())
      frame.box = read_lattice(lattice, find("pbc"));
    read_properties(find("Properties"));
  }

  BoxGeometry read_lattice(std::string_view text, std::string_view periodic) const {
    std::array<double, 9> v{};
    for (double& component : v) {
      const auto value = number(take_word(text));
      if (!value) refuse("Lattice needs nine numbers", "they are the three box vectors");
      component = *value;
    }
    if (v[1] != 0 || v[2] != 0 || v[5] != 0 || v[6] != 0 || v[7] != 0 || !(v[0] > 0) || !(v[4] > 0) || !(v[8] > 0))
      refuse("this Lattice is no sheared box",
             "only \"Lx 0 0 offset Ly 0 0 0 Lz\" with positive lengths can be sheared");
    take_word(periodic);
    return {{v[0], v[4], v[8]}, v[3], take_word(periodic) != "F"};
  }

  void read_properties(std::string_view text) {
    if (text.empty()) text = "species:S:1:pos:R:3";
    properties_.clear();
    words_ = 0;
    const auto take = [&] {
      const std::string_view part = text.substr(0, text.find(':'));
      text.remove_prefix(std::min(text.size(), part.size() + 1));
      return part;
    };
    while (!text.empty()) {
      const std::string name(take());
      const std::string_view type = take();
      const auto count = number<std::uint32_t>(take());
      if (name.empty() || type.size() != 1 || !count || *count == 0)
        refuse("Properties is malformed", "it is a list of name:type:count, such as pos:R:3");
      properties_.push_back({name, type[0], words_, *count});
      words_ += *count;
    }
    const auto position = std::find_if(properties_.begin(), properties_.end(),
                                       [](const Property& p) { return p.name == "pos" && p.count == 3; });
    if (position == properties_.end()) refuse("Properties has no pos:R:3", "a particle needs a position");
  }

  void read_particle(std::string_view line, XyzFrame& frame) {
    word_.clear();
    for (std::string_view w = take_word(line); !w.empty(); w = take_word(line)) word_.push_back(w);
    if (word_.size() != words_)
      refuse(fmt::format("{} values in this line", word_.size()), fmt::format("Properties asks for {}", words_));
    for (const Property& p : properties_) {
      if (p.name == "pos") read_numbers(p, frame.position);
      if (p.name == "radius") read_numbers(p, frame.radius);
      if (p.name == "velo" || p.name == "velocity") read_numbers(p, frame.velocity);
      if (p.name == "angular_velocity") read_numbers(p, frame.angular_velocity);
      if (p.name == "id") frame.id.push_back(read_integer(p));
      if (p.name == "species") frame.species.push_back(p.type == 'S' ? species_named(word_[p.first]) : read_integer(p));
    }
  }

  void read_numbers(const Property& p, std::vector<double>& into) const {
    for (std::size_t k = p.first; k < p.first + p.count; ++k) {
      const auto value = number(word_[k]);
      if (!value) refuse(fmt::format("'{}' in {}", word_[k], p.name), "it is no finite number");
      into.push_back(*value);
    }
  }

  std::int32_t read_integer(const Property& p) const {
    const auto value = number<std::int32_t>(word_[p.first]);
    if (!value) refuse(fmt::format("'{}' in {}", word_[p.first], p.name), "it is no integer");
    return *value;
  }

  std::int32_t species_named(std::string_view name) {
    return species_.try_emplace(std::string(name), std::int32_t(species_.size())).first->second;
  }

  std::string file_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::vector<Property> properties_;
  std::size_t words_ = 0;
  std::vector<std::string_view> word_;
  std::map<std::string, std::int32_t> species_;
};

}  // namespace

XyzFrame read_last_xyz_frame(const std::filesystem::path& file) {
  const std::string text = read_whole_file(file);
  FrameReader counter(file.string(), text), reader(file.string(), text);
  std::size_t frames = 0;
  do {
    counter.frame(true);
    ++frames;
  } while (!counter.at_end());
  for (std::size_t k = 1; k < frames; ++k) reader.frame(true);
  return reader.frame(false);
}

}  // namespace stresslet
