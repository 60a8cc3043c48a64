/**
 * Learns the state machine of a device from the device itself, by operating it and listening.
 *
 * <p>The parts, and the way that data takes:
 *
 * <pre>
 * Learner  --a word of inputs-->  Answers  --what is not known yet-->  Session  --press, wait, reset-->  LearnedDevice
 *    |                               |                                    |
 *    TTT of LearnLib, Suite          AnswerTree, AnswerLog                LearnRules
 * </pre>
 *
 * <p>{@link org.evoloop.learn.LearnedDevice} is the port: it presses, listens until the device is quiet, and resets.
 * {@code Session} takes one word to it. It checks {@link org.evoloop.learn.LearnRules} before anything is sent, and repeats a
 * word if a person or the connection came between.
 *
 * <p>{@code Answers} owns what was heard, in a tree, and as lines of a file if there is one. An answer is asked for
 * once. An input that leaves the device alone (a wait in which nothing happens, an input that a rule forbids) leads back to
 * the same node of the tree, so that nothing is asked twice behind it.
 *
 * <p>If the device contradicts the tree, the question is put again until a vote decides. If the tree was wrong, it is cut
 * there, and the learner begins again from the tree, which costs no press. A process that was killed begins again in the same
 * way: it asks the same words in the same order, and the file answers as far as it goes. An edge on which no vote decides is named, and learning ends.
 *
 * <p>Time: waiting is an input, {@link org.evoloop.learn.LearnedDevice#WAIT}. Each state is observed once; what the device
 * does then is an act of its own, after an interval. Tests wait only as their last step, unless only a timer leads to a state.
 *
 * <p>The result is a {@link org.evoloop.learn.Learned}, which says how often each transition was seen, and what is open.
 */
@NullMarked
package org.evoloop.learn;

import org.jspecify.annotations.NullMarked;
