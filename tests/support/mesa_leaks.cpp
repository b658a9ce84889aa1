// For test programs that load the GL module: Mesa keeps memory and threads that LeakSanitizer cannot always read,
// so that it is not to look.
extern "C" int __lsan_is_turned_off();
extern "C" int __lsan_is_turned_off() { return 1; }
