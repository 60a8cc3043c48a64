/**
 * For tests of a converter: {@link org.evoloop.testkit.ConverterHarness} runs it without threads under a {@link
 * org.evoloop.time.ManualClock}, {@link org.evoloop.testkit.SimulatedDevice} replaces the device, and {@link
 * org.evoloop.testkit.OrderCheck} checks that an adapter reports things in the order in which they happened. {@link
 * org.evoloop.testkit.Recording} replays a converter's inputs with other models.
 *
 * <p>This package uses the framework and Logback, which receives the transcript. It needs no particular test framework:
 * a failed expectation is an {@link AssertionError}.
 */
@NullMarked
package org.evoloop.testkit;

import org.jspecify.annotations.NullMarked;
