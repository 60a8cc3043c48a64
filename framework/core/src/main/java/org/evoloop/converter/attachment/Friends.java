package org.evoloop.converter.attachment;

import java.util.function.Consumer;
import org.evoloop.loop.Analyze;
import org.evoloop.loop.Execute;
import org.evoloop.loop.Knowledge;
import org.evoloop.loop.Monitor;
import org.evoloop.loop.Plan;

/** The {@link Friend} of each class that has one. */
public final class Friends {
    /** Of {@code EventMonitor}. */
    public static final Friend<Monitor<?>, MonitorAccess> MONITOR = new Friend<>();

    /** Of {@code EventAnalyze}: attaches it. */
    public static final Friend<Analyze<?, ?>, Consumer<DecisionHost>> ANALYZE = new Friend<>();

    /** Of {@code EventPlan}: attaches it. */
    public static final Friend<Plan<?, ?>, Consumer<DecisionHost>> PLAN = new Friend<>();

    /** Of {@code EventExecute}. */
    public static final Friend<Execute<?>, ExecuteAccess> EXECUTE = new Friend<>();

    /** Of {@code StateKnowledge}. */
    public static final Friend<Knowledge, KnowledgeAccess> KNOWLEDGE = new Friend<>();

    private Friends() {}
}
