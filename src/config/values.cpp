#include "config/values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <variant>
#include <vector>

#include "config/nearest.hpp"
#include "core/contract.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

std::string shown(const Node& node) {
  struct Show {
    std::string operator()(const std::string& text) const { return quote(text.substr(0, 80)); }
    std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(const DateOrTime&) const { return "a date or time"; }
    std::string operator()(const List& list) const { return fmt::format("a list of {}", list.items.size()); }
    std::string operator()(const Table&) const { return "a table"; }
  };
  return std::visit(Show{}, node.value);
}

InputError wrong(const Key& key, const Node& node) {
  const auto allowed = allowed_text(key);
  return InputError(fmt::format("{} does not fit; allowed is {}{}", shown(node), type_text(key),
                                allowed.empty() ? "" : ": " + allowed));
}

void check_range(const Key& key, double value, const std::string& as_written, const std::string& hint = "") {
  const auto& [least, most] = key.range;
  const bool low = least && (least->edge == Edge::excluded ? value <= least->value : value < least->value);
  const bool high = most && (most->edge == Edge::excluded ? value >= most->value : value > most->value);
  if (low || high)
    throw InputError(fmt::format("{} is out of range; allowed: {}{}", as_written, allowed_text(key), hint));
}

// What a number without a unit means, for those who forgot the unit.
std::string bare_number_text(const Key& key, const Node& node) {
  const QuantityInfo& wanted = info(key.quantity);
  if (node.as<std::string>() || wanted.unit.empty()) return "";
  return fmt::format("; a number without a unit is in {}, with one: \"{}\"", wanted.unit, wanted.example);
}

double read_number(const Key& key, const Node& node) {
  double value = 0.0;
  if (const auto* number = node.as<double>()) {
    value = *number;
  } else if (const auto* integer = node.as<std::int64_t>()) {
    value = static_cast<double>(*integer);
  } else if (const auto* text = node.as<std::string>(); text && key.quantity != Quantity::number) {
    value = parse_quantity(*text, key.quantity);
  } else {
    throw wrong(key, node);
  }
  if (!std::isfinite(value)) {
    throw InputError(fmt::format("{} is not a finite number; allowed is {}", shown(node), type_text(key)));
  }
  check_range(key, value, shown(node), bare_number_text(key, node));
  return value;
}

Vec3 read_vector(const Key& key, const Node& node) {
  const auto* list = node.as<List>();
  if (!list && key.type == Type::scalar_or_vector) return Vec3::Constant(read_number(key, node));
  if (!list || list->items.size() != 3) throw wrong(key, node);
  Vec3 result;
  for (std::size_t axis = 0; axis < 3; ++axis)
    result[static_cast<Eigen::Index>(axis)] = read_number(key, list->items[axis]);
  return result;
}

std::int64_t read_integer(const Key& key, const Node& node) {
  const auto* integer = node.as<std::int64_t>();
  if (!integer) throw wrong(key, node);
  check_range(key, static_cast<double>(*integer), shown(node));
  return *integer;
}

std::string read_text(const Key& key, const Node& node) {
  const auto* text = node.as<std::string>();
  if (!text) throw wrong(key, node);
  if (key.type == Type::path && (text->empty() || text->find('\0') != text->npos))
    throw InputError("an empty or impossible file name; allowed is " + type_text(key));
  return *text;
}

int read_choice(const Key& key, const Node& node) {
  const std::string name = read_text(key, node);
  std::vector<std::string> names;
  for (std::size_t index = 0; index < key.choices.size(); ++index) {
    const Choice& choice = key.choices[index];
    names.emplace_back(choice.name);
    if (choice.name != name) continue;
    if (choice.status == Status::available) return static_cast<int>(index);
    throw InputError(fmt::format("\"{}\" is not available yet; allowed: {}", name, allowed_text(key)));
  }
  throw InputError(
      fmt::format("{} is unknown{}; allowed: {}", shown(node), did_you_mean(name, names), allowed_text(key)));
}

std::vector<int> read_choices(const Key& key, const Node& node) {
  const auto* list = node.as<List>();
  if (!list || list->items.empty()) throw wrong(key, node);
  std::vector<int> result;
  for (const Node& item : list->items) {
    result.push_back(read_choice(key, item));
    if (std::count(result.begin(), result.end(), result.back()) > 1)
      throw InputError(fmt::format("{} stands there twice; allowed: each once", shown(item)));
  }
  return result;
}

std::vector<std::int64_t> read_integers(const Key& key, const Node& node) {
  const auto* list = node.as<List>();
  if (!list || list->items.empty()) throw wrong(key, node);
  std::vector<std::int64_t> result;
  for (const Node& item : list->items) result.push_back(read_integer(key, item));
  return result;
}

bool is_auto(const Key& key, const Node& node) {
  const auto* text = node.as<std::string>();
  return key.automatic == Automatic::accepted && text && *text == "auto";
}

// Reads into whatever member the slot leads to.
struct Read {
  const Key& key;
  const Node& node;
  Target& target;

  void operator()(std::monostate) const { FRIT_ASSERT(false); }
  void operator()(const ListAccess&) const { FRIT_ASSERT(false); }
  void operator()(Access<std::string> member) const { member(target) = read_text(key, node); }
  void operator()(Access<std::optional<std::filesystem::path>> member) const {
    member(target) = read_text(key, node);
  }
  void operator()(Access<bool> member) const {
    const auto* value = node.as<bool>();
    if (!value) throw wrong(key, node);
    member(target) = *value;
  }
  void operator()(Access<std::int64_t> member) const { member(target) = read_integer(key, node); }
  void operator()(Access<std::optional<std::int64_t>> member) const {
    member(target) = read_integer(key, node);
  }
  void operator()(Access<double> member) const { member(target) = read_number(key, node); }
  void operator()(Access<std::optional<double>> member) const {
    if (is_auto(key, node)) {
      member(target).reset();
    } else {
      member(target) = read_number(key, node);
    }
  }
  void operator()(Access<Vec3> member) const { member(target) = read_vector(key, node); }
  void operator()(Access<std::optional<Vec3>> member) const { member(target) = read_vector(key, node); }
  void operator()(Access<std::vector<std::int64_t>> member) const {
    member(target) = read_integers(key, node);
  }
  void operator()(const ChoiceAccess& member) const { member.set(target, read_choice(key, node)); }
  void operator()(const ChoiceListAccess& member) const { member.set(target, read_choices(key, node)); }
};

std::string number_text(double value) {
  const std::string digits = fmt::format("{}", value);
  // A float, not an integer: TOML would lose the sign of -0.
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

struct Write {
  const Key& key;
  Target& target;
  using Text = std::optional<std::string>;

  Text operator()(std::monostate) const { return {}; }
  Text operator()(const ListAccess&) const { return {}; }
  Text operator()(Access<std::string> member) const { return text(member(target)); }
  Text operator()(Access<bool> member) const { return text(member(target)); }
  Text operator()(Access<std::int64_t> member) const { return text(member(target)); }
  Text operator()(Access<double> member) const { return text(member(target)); }
  Text operator()(Access<Vec3> member) const { return text(member(target)); }
  Text operator()(Access<std::vector<std::int64_t>> member) const { return text(member(target)); }
  template <class T>
  Text operator()(Access<std::optional<T>> member) const {
    if (const auto& value = member(target)) return text(*value);
    return key.automatic == Automatic::accepted ? Text("\"auto\"") : Text();
  }
  Text operator()(const ChoiceAccess& member) const {
    const auto index = member.get(target);
    return index ? Text(choice(*index)) : Text();
  }
  Text operator()(const ChoiceListAccess& member) const {
    std::string list;
    for (const int index : member.get(target))
      list += fmt::format("{}{}", list.empty() ? "" : ", ", choice(index));
    return "[" + list + "]";
  }

  std::string choice(int index) const {
    return quote(std::string(key.choices[static_cast<std::size_t>(index)].name));
  }

  static Text text(const std::string& value) { return quote(value); }
  static Text text(const std::filesystem::path& value) { return quote(value.string()); }
  static Text text(bool value) { return value ? "true" : "false"; }
  static Text text(std::int64_t value) { return fmt::format("{}", value); }
  static Text text(double value) { return number_text(value); }
  static Text text(const Vec3& value) {
    return fmt::format("[{}, {}, {}]", number_text(value.x()), number_text(value.y()),
                       number_text(value.z()));
  }
  static Text text(const std::vector<std::int64_t>& values) {
    std::string list;
    for (const auto value : values) list += fmt::format("{}{}", list.empty() ? "" : ", ", value);
    return "[" + list + "]";
  }
};

}  // namespace

void read_value(const Key& key, const Node& node, Target& target) {
  std::visit(Read{key, node, target}, key.slot);
}

std::optional<std::string> write_value(const Key& key, Target& target) {
  return std::visit(Write{key, target}, key.slot);
}

std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (code < 0x20 || code == 0x7F) {
      quoted += fmt::format("\\u{:04X}", code);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

}  // namespace frit::config
