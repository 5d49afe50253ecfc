#include "io/cbor_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"

namespace frit::io {
namespace {

using nlohmann::json;

InputError wrong(const std::string& name, std::string_view what) {
  return InputError(fmt::format("'{}' {}", name.substr(0, 80), what));
}

}  // namespace

// Takes what the library's reader meets; lists and maps within the map end the reading, so nothing recurses.
class CborMap::Reader : public nlohmann::json_sax<json> {
 public:
  bool null() override { return false; }
  bool boolean(bool) override { return false; }
  bool number_integer(number_integer_t value) override { return take(std::int64_t{value}); }
  bool number_unsigned(number_unsigned_t value) override {
    return std::in_range<std::int64_t>(value) && take(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return take(double{value}); }
  bool string(string_t& value) override { return take(std::move(value)); }
  bool binary(binary_t& value) override { return take(Bytes(std::move(value))); }
  bool start_object(std::size_t) override { return !std::exchange(is_open_, true); }
  bool key(string_t& name) override {
    name_ = std::move(name);
    return true;
  }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return false; }
  bool end_array() override { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

  CborMap map;

 private:
  bool take(Value value) { return is_open_ && map.values_.insert_or_assign(name_, std::move(value)).second; }

  bool is_open_ = false;
  std::string name_;
};

void CborMap::put_bytes(const std::string& name, Bytes bytes, std::size_t entry_bytes) {
  const bool is_long = entry_bytes > 0 && bytes.size() > entry_bytes;
  if (is_long && std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; }))
    return put(name, static_cast<std::int64_t>(bytes.size() / entry_bytes));
  values_[name] = std::move(bytes);
}

const CborMap::Value& CborMap::value(const std::string& name) const {
  const auto found = values_.find(name);
  if (found == values_.end()) throw wrong(name, "is missing");
  return found->second;
}

double CborMap::real(const std::string& name) const {
  const Value& found = value(name);
  if (const auto* number = std::get_if<double>(&found)) return *number;
  throw wrong(name, "is no real number");
}

std::int64_t CborMap::whole(const std::string& name) const {
  const Value& found = value(name);
  if (const auto* number = std::get_if<std::int64_t>(&found)) return *number;
  throw wrong(name, "is no whole number");
}

const std::string& CborMap::text(const std::string& name) const {
  const Value& found = value(name);
  if (const auto* words = std::get_if<std::string>(&found)) return *words;
  throw wrong(name, "is no text");
}

std::size_t CborMap::count(const std::string& name, std::size_t entry_bytes) const {
  const Value& found = value(name);
  const auto* bytes = std::get_if<Bytes>(&found);
  if (bytes == nullptr || bytes->size() % entry_bytes != 0) throw wrong(name, "is no array of its kind");
  return bytes->size() / entry_bytes;
}

const CborMap::Bytes* CborMap::bytes_of(const std::string& name, std::size_t count,
                                        std::size_t entry_bytes) const {
  const Value& found = value(name);
  if (const auto* zeros = std::get_if<std::int64_t>(&found)) {
    if (std::cmp_not_equal(*zeros, count)) throw wrong(name, fmt::format("needs {} entries", count));
    return nullptr;
  }
  const auto* bytes = std::get_if<Bytes>(&found);
  if (bytes == nullptr || bytes->size() != count * entry_bytes) {
    throw wrong(name, fmt::format("needs {} entries", count));
  }
  return bytes;
}

void CborMap::move_to(std::string& bytes) {
  json object = json::object();
  for (auto& [name, value] : values_) {
    if (auto* array = std::get_if<Bytes>(&value)) {
      object[name] = json::binary(std::move(*array));
    } else {
      std::visit([&, &key = name](const auto& plain) { object[key] = plain; }, value);
    }
  }
  values_.clear();
  json::to_cbor(object, bytes);
}

CborMap CborMap::parse(std::string_view bytes) {
  Reader reader;
  if (!json::sax_parse(bytes.begin(), bytes.end(), &reader, json::input_format_t::cbor)) {
    throw InputError("the bytes are no map of numbers, texts and arrays, each name once");
  }
  return std::move(reader.map);
}

}  // namespace frit::io
