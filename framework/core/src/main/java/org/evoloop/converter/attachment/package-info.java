/**
 * What components and knowledge know of the converter to which they are attached, and the other way round. A user
 * extends {@code EventMonitor}, {@code EventAnalyze}, {@code EventPlan}, {@code EventExecute} and {@code StateKnowledge};
 * the packages behind need more of them than a user may call. No module exports this package, so users can name nothing
 * of it.
 *
 * <pre>
 *  user's class ──▶ EventExecute ──▶ ExecuteAccess.Host      the converter carries out a plan, hears of an effect
 *                        ▲                │ implemented by running.PlanExecutor, edge.EdgeShell
 *                        │ gives          ▼
 *                   ExecuteAccess ◀── Friends.EXECUTE.of(execute)
 * </pre>
 *
 * <ul>
 *   <li>{@link org.evoloop.converter.attachment.ExecuteAccess.Host} and {@link org.evoloop.converter.attachment.DecisionHost}:
 *       what a component may ask of the converter.
 *   <li>{@link org.evoloop.converter.attachment.UserCode}: calls what a user wrote, and contains what it throws.
 *   <li>{@link org.evoloop.converter.attachment.Endings}: tells a monitor how an occurrence ends.
 *   <li>{@link org.evoloop.converter.attachment.ExecuteAccess}, {@link org.evoloop.converter.attachment.MonitorAccess} and
 *       {@link org.evoloop.converter.attachment.KnowledgeAccess}: what the converter asks of them, but no user.
 *   <li>{@link org.evoloop.converter.attachment.Friends}: how to get that from an object, as by the {@code SharedSecrets}
 *       of the JDK: its class gives the access when it is initialized, since only the class itself reaches what is private
 *       in it.
 * </ul>
 *
 * <p>This package may use {@code org.evoloop.converter.binding}, {@code loop}, {@code function}, {@code evolution} and what
 * those use; {@code org.evoloop.converter} uses it, not the other way round.
 */
@NullMarked
package org.evoloop.converter.attachment;

import org.jspecify.annotations.NullMarked;
