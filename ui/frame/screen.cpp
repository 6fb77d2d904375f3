#include "ui/frame/screen.h"

// The signals of Screen are compiled here.
