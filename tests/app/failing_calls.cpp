// Preloaded into the program: the n-th of its calls that change files fails as on a full disk. FAIL_AT names
// n (0: none), COUNT_TO a file that gets the number of calls at the end.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace {

// Counts the calls of a process, and tells them at its end.
class Counter {
 public:
  bool fails() {
    const char* at = std::getenv("FAIL_AT");
    if (at == nullptr || ++calls_ != std::atol(at)) return false;
    errno = ENOSPC;
    return true;
  }
  ~Counter() {
    const char* path = std::getenv("COUNT_TO");
    std::FILE* file = path != nullptr ? std::fopen(path, "w") : nullptr;
    if (file == nullptr) return;
    std::fprintf(file, "%ld\n", calls_);
    std::fclose(file);
  }

 private:
  long calls_ = 0;
} counter;

template <class Call>
Call real(const char* name) {
  return reinterpret_cast<Call>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t write(int file, const void* bytes, size_t count) {
  if (file > STDERR_FILENO && counter.fails()) return -1;
  return real<ssize_t (*)(int, const void*, size_t)>("write")(file, bytes, count);
}

int fsync(int file) { return counter.fails() ? -1 : real<int (*)(int)>("fsync")(file); }

int rename(const char* from, const char* to) noexcept {
  return counter.fails() ? -1 : real<int (*)(const char*, const char*)>("rename")(from, to);
}

int ftruncate(int file, off_t length) noexcept {
  return counter.fails() ? -1 : real<int (*)(int, off_t)>("ftruncate")(file, length);
}

int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if ((flags & O_CREAT) != 0 && counter.fails()) return -1;
  return real<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}

}  // extern "C"
