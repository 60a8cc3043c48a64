/**
 * The MAPE-K loop (paper, sections II.B and V.A): the superclasses {@link org.evoloop.loop.Monitor}, {@link
 * org.evoloop.loop.Analyze}, {@link org.evoloop.loop.Plan}, {@link org.evoloop.loop.Execute} and {@link
 * org.evoloop.loop.Knowledge}, and the {@link org.evoloop.loop.MapeLoop} that hands their results on, supervises them
 * and lets them be exchanged while it runs.
 *
 * <pre>
 *  Monitor ─▶ MonitorWorker ─▶ Sequencer ─▶ StageWorker ─▶ StageWorker ─▶ StageWorker
 *             its thread        │  whose turn   Analyze        Plan           Execute
 *                               ▼  it is             └─ Pipeline ─┴─ Dispatch ─┘
 *                            Intake: the queue
 * </pre>
 *
 * <ul>
 *   <li>Lifecycle: {@code Gate} opens, closes and holds the loop; {@code Roster} has its components.
 *   <li>Threads: {@code Crew} assigns each component a {@code CarrierThread}, as {@link
 *       org.evoloop.loop.ThreadingModel} says, and replaces one that hangs; {@code Supervisor} notices that it does.
 *   <li>Queue: {@link org.evoloop.loop.Intake}, by default a {@code PlainQueue}.
 * </ul>
 *
 * <p>This package may use {@code org.evoloop.time} and {@code org.evoloop.flight} only; it knows nothing of state
 * machines. All threads of the framework but those of new functions live here.
 */
@NullMarked
package org.evoloop.loop;

import org.jspecify.annotations.NullMarked;
