#include "core/error.h"

#include <gtest/gtest.h>

namespace cutaway {
namespace {

TEST(Error, SaysFieldLimitAndWhatCame) {
  const Error error({.code = ErrorCode::out_of_range,
                     .message = "the lens is too large",
                     .field = "/lens/radius_mm",
                     .expected = "0 to 2000 mm",
                     .received = "1e9"});
  EXPECT_STREQ(error.what(),
               "the lens is too large (/lens/radius_mm); expected 0 to 2000 mm; got 1e9");
}

TEST(Error, LeavesOutWhatDoesNotApply) {
  EXPECT_STREQ(Error({.code = ErrorCode::internal, .message = "no"}).what(), "no");
}

}  // namespace
}  // namespace cutaway
