/**
 * Learns the state machine of a device by pressing its inputs.
 *
 * <p>{@link org.evoloop.learn.Learning} puts words, which are inputs from a reset on, to a
 * {@link org.evoloop.learn.LearnableDevice}. The algorithm is LearnLib's TTT; what it asks goes through an oracle of our
 * own, which keeps every answer ever heard in a tree, with counts, and each run in a log before it counts. So three things
 * are one mechanism:
 *
 * <ul>
 *   <li>Noise: an answer that differs from an earlier one is voted on. The noisier the device, the larger the lead that an
 *       answer needs. The algorithm then starts again and gets its old answers from the tree, without a press.
 *   <li>A kill: a run that was not written to the end did not happen.
 *   <li>Resuming: the tree is what the log says.
 * </ul>
 *
 * <p>Time: waiting is one more input. A wait in which nothing happens for the longest time changes nothing, so a state is
 * observed once, and what follows a quiet wait is known from what follows without it. Tests wait only as their last step,
 * besides where a state is reached only by waiting. When a device does something by itself, this is a spontaneous event; its time is an
 * interval, measured from the first sign of the state.
 *
 * <p>Looking is an input, too. It costs nothing, since each answer has what the device shows, and it keeps apart states that
 * look different.
 *
 * <p>The tests reach each state, take up to two inputs, and then look where they are. A machine that passes is tested to
 * depth 1; that the device has no more states cannot be proved from outside.
 *
 * <p>It may use {@code statemachine}, {@code time}, the model files, LearnLib and AutomataLib; those two appear in
 * no signature of the API.
 */
@NullMarked
package org.evoloop.learn;

import org.jspecify.annotations.NullMarked;
