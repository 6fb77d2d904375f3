#include "ui/frame/station.h"

// The signals of Station are compiled here.
