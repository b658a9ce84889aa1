#pragma once
#include "flatray/traced.h"
