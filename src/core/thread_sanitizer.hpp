// What the thread sanitizer cannot see: Debian's TBB is not instrumented, so the order that a parallel loop
// has against what stands before and after it is told here. The order of blocks among each other is not told:
// there is none, and races between them are found.
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define FRIT_THREAD_SANITIZER
extern "C" {
void __tsan_acquire(
    void* address);  // NOLINT(bugprone-reserved-identifier,readability-identifier-naming): clang's names
void __tsan_release(void* address);  // NOLINT(bugprone-reserved-identifier,readability-identifier-naming)
}
#endif
#endif

namespace frit::detail {

// One parallel loop, or pair of functions. Nothing but in the preset tsan.
class ForkAndJoin {
 public:
#ifdef FRIT_THREAD_SANITIZER
  ForkAndJoin() { __tsan_release(&fork_); }
  void begin_part() { __tsan_acquire(&fork_); }
  void end_part() { __tsan_release(&join_); }
  void join() { __tsan_acquire(&join_); }

 private:
  char fork_ = 0, join_ = 0;  // two, so that the end of one part does not come before the start of another
#else
  void begin_part() {}
  void end_part() {}
  void join() {}
#endif
};

}  // namespace frit::detail
