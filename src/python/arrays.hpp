// NumPy arrays over memory of ours: views that keep their owner alive, or arrays that take a vector over.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec.hpp"
#include "io/frame.hpp"

namespace frit::python {

namespace py = pybind11;

// Numbers that stand side by side in one entry of a vector, and how many.
template <class Entry>
struct Layout {
  using Number = Entry;
  static constexpr py::ssize_t count = 1;
};
template <>
struct Layout<Vec3> {
  using Number = double;
  static constexpr py::ssize_t count = 3;
};
template <>
struct Layout<Quat> {
  using Number = double;
  static constexpr py::ssize_t count = 4;
};
template <>
struct Layout<Image> {
  using Number = std::int8_t;
  static constexpr py::ssize_t count = 3;
};

// A read-only array over `values` without a copy, one row an entry. `owner` is the Python object that holds
// them; the array keeps it alive.
template <class Entry>
py::array view_of(const std::vector<Entry>& values, const py::object& owner) {
  using Number = typename Layout<Entry>::Number;
  constexpr py::ssize_t count = Layout<Entry>::count;
  static_assert(sizeof(Entry) == sizeof(Number) * static_cast<std::size_t>(count));
  const auto rows = static_cast<py::ssize_t>(values.size());
  const auto* first = reinterpret_cast<const Number*>(values.data());
  py::array array = count == 1 ? py::array(py::dtype::of<Number>(), {rows}, first, owner)
                               : py::array(py::dtype::of<Number>(), {rows, count}, first, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

// An array that owns what was in `values`, without a copy; `components` numbers a row.
template <class Number>
py::array array_of(std::vector<Number> values, int components = 1) {
  auto* kept = new std::vector<Number>(std::move(values));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
  const auto rows = static_cast<py::ssize_t>(kept->size()) / components;
  if (components == 1) return py::array(py::dtype::of<Number>(), {rows}, kept->data(), owner);
  return py::array(py::dtype::of<Number>(), {rows, py::ssize_t{components}}, kept->data(), owner);
}

// Named arrays as a dict, emptied.
inline void add_arrays(py::dict& dict, std::vector<io::NamedArray>&& arrays) {
  for (io::NamedArray& array : arrays) {
    dict[py::str(array.name)] =
        std::visit([&](auto& values) { return array_of(std::move(values), array.components); }, array.values);
  }
}

}  // namespace frit::python
