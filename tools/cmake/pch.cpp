// Holds the precompiled header that every module uses again.
