#include "render/coverage_scan.h"
namespace flatray {
void scan_ring(const FillRing&, Coverage, const PixelBox&, RunList&, CoverageStats&) {}
}
