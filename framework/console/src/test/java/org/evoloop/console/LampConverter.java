package org.evoloop.console;

import java.time.Duration;
import java.util.Set;
import org.evoloop.PaperModels;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;

/** The converter of the paper's light bulb, with a wall switch and two spares for it. */
final class LampConverter {
    final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    final SystemEventConverter converter;

    LampConverter(LoopConfig config) {
        converter = new SystemEventConverter(config);
        converter.addMonitor(wallSwitch);
        converter.addExecute(new Lamp());
        converter.addKnowledge(new LampKnowledge(PaperModels.lightBulb()));
        converter.addKnowledgeFactory(LampKnowledge::new);
        converter.addSpare("spareSwitch", () -> new PushMonitor("SpareSwitch"));
        converter.addSpare("otherSwitch", () -> new PushMonitor("OtherSwitch"));
        converter.build();
    }

    /** Presses the switch and converts what waits, in a converter without threads. */
    ConsoleCommand switchCommand() {
        return ConsoleCommand.of("switch", "operates the wall switch\nlike a finger", (arguments, out) -> {
            wallSwitch.press("switch");
            converter.observe(wallSwitch);
            converter.step();
        });
    }

    private static final class Lamp extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("switch");
        }

        @Override
        protected void send(Step step) {}
    }

    private static final class LampKnowledge extends StateKnowledge {
        LampKnowledge(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            timer("wait", "timeout", Duration.ofSeconds(2));
            function("incandescentOn", NewFunction.none());
        }
    }
}
