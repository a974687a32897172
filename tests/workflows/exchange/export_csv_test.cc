// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/export_csv.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/workflows/exchange/quoted_walker.h"
#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/motion_columns.h"

namespace gaitwright {
namespace {

TEST(MotionCsvText, IsReadBackExactlyAtAnyRate) {
  const QuotedWalker walker;
  for (const double rate_hz : {200.0, 333.0}) {
    const MotionRows rows = RowsOfPlan(walker.model, walker.plan, rate_hz);
    const std::string text = MotionCsv(walker.model, rows);
    EXPECT_EQ(text, MotionCsv(walker.model, rows));
    const Result<CsvTable> table = ParseCsvTable(text, "motion.csv");
    ASSERT_TRUE(table) << table.failure().message;
    EXPECT_EQ(table->columns, MotionCsvColumns(walker.model));
    const Result<MotionTable> read = MotionFromCsv(walker.model, *table, {}, {});
    ASSERT_TRUE(read) << read.failure().message;
    ASSERT_EQ(read->rows(), rows.size());
    EXPECT_EQ(read->time_s, rows.time_s);
    for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
      ASSERT_TRUE(AreSame(read->q[k], rows.q[k].tail(6)) && AreSame(read->v[k], rows.v[k].tail(6))) << k;
      ASSERT_TRUE(AreSame(read->a[k], rows.a[k].tail(6)) && AreSame(read->base_rate[k], rows.v[k].head(6))) << k;
      ASSERT_TRUE(AreSame(read->base_acceleration[k], rows.a[k].head(6))) << k;
      ASSERT_TRUE(AreSame(read->tau[k], rows.tau[k]) && read->base_m[k] == rows.q[k].head<3>()) << k;
      ASSERT_EQ(read->contact[k], rows.contact[k]) << k;
    }
  }
}

TEST(MotionCsvText, NamesItsColumnsWithTheirUnits) {
  const QuotedWalker walker;
  const std::string text = MotionCsv(walker.model, RowsOfPlan(walker.model, walker.plan, 100.0));
  const std::string head = text.substr(0, text.find('\n'));
  EXPECT_TRUE(
      head.starts_with("time_s,base_x_m,base_y_m,base_z_m,base_qx,base_qy,base_qz,base_qw,q_left_x_m,q_left_y_rad,"
                       "\"q_left, \"\"z\"\"_m\""))
      << head;
  EXPECT_TRUE(head.ends_with("tau_right_z_n,contact_left,contact_right")) << head;
  EXPECT_TRUE(synthetic::Says(head, "v_left_y_rad_s,") && synthetic::Says(head, "tau_left_y_nm,")) << head;
}

TEST(MotionCsvText, LeavesOutWhatThereIsNotAndRefusesWhatIsNotFinite) {
  QuotedWalker walker;
  walker.plan.whole_body.tau.clear();
  MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  EXPECT_FALSE(synthetic::Says(MotionCsv(walker.model, rows), "tau_"));
  rows.q[3][7] = NAN;
  EXPECT_EQ(RefusalText([&] { MotionCsv(walker.model, rows); }),
            "column 'q_left_x_m' is nan at 0.03 s; only finite numbers are exported");
}

}  // namespace
}  // namespace gaitwright
