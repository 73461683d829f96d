#include "render/samples.h"

#include <gtest/gtest.h>

using namespace dioptre;

TEST(SampleBatches, CoverEverySampleOnceInOrder)
{
    for (const int samples : {1, 7, 16, 1000}) {
        int next = 0;
        for (const auto& batch : sampleBatches(samples, 300, true)) {
            EXPECT_EQ(batch.first, next);
            EXPECT_GT(batch.count, 0);
            next += batch.count;
        }
        EXPECT_EQ(next, samples);
    }
}

TEST(SampleBatches, StayWithinTheLoopsThatLlvmpipeRuns)
{
    for (const long iterations : {1L, 17L, 4000L, 65535L})
        for (const auto& batch : sampleBatches(4096, iterations, true))
            EXPECT_LE(batch.count * iterations, 65535L);
}

TEST(SampleBatches, ASampleBeyondTheCap_IsRefusedOnSoftwareAlone)
{
    EXPECT_THROW(sampleBatches(1, 65536, true), Error);
    EXPECT_EQ(sampleBatches(1, 65536, false).size(), 1U);
}

TEST(SampleBatches, AreTheSameOnEveryDriver)
{
    EXPECT_EQ(sampleBatches(1000, 300, true).size(), sampleBatches(1000, 300, false).size());
}
