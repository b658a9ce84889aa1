#pragma once

// Included by base/check.h and, for programs that call the library, by status.h: exact decisions rest on arithmetic
// as IEEE 754 has it, each operation rounded once to double.
#if defined(__FAST_MATH__)
#error "flatray needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error \
    "flatray needs IEEE 754 arithmetic: doubles must not be evaluated in a wider format (on x86: -mfpmath=sse)"
#endif
