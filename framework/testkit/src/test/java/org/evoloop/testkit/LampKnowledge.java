package org.evoloop.testkit;

import java.time.Duration;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.function.NewFunction;

/** What the paper's light bulb knows. */
final class LampKnowledge extends StateKnowledge {
    LampKnowledge() {
        super(Models.lightBulb());
    }

    @Override
    protected void registerNewFunctions() {
        timer("wait", "timeout", Duration.ofSeconds(2));
        function("incandescentOn", NewFunction.none());
    }
}
