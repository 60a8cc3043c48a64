/**
 * For tests of a converter: {@link org.evoloop.testkit.ConverterHarness} runs it without threads under a {@link
 * org.evoloop.time.ManualClock}, {@link org.evoloop.testkit.SimulatedDevice} stands in for the device, and {@link
 * org.evoloop.testkit.OrderCheck} sees whether an adapter tells things in the order in which they happened. {@link
 * org.evoloop.testkit.Recording} has other models decide what a converter was told.
 *
 * <p>This package uses the framework and Logback, which hears the transcript. It needs no particular test framework:
 * what does not hold is an {@link AssertionError}.
 */
@NullMarked
package org.evoloop.testkit;

import org.jspecify.annotations.NullMarked;
