package com.example.lamp;

import java.time.Duration;
import org.evoloop.converter.StateKnowledge;

/** What the new states do. */
final class LampKnowledge extends StateKnowledge {
    LampKnowledge() {
        super(Models.lamp());
    }

    @Override
    protected void registerNewFunctions() {
        timer("wait", "timeout", Duration.ofSeconds(2));
        function("warm", visit -> System.out.println("a warm light"));
    }
}
