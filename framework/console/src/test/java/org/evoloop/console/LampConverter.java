package org.evoloop.console;

import org.evoloop.LightBulb;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.LoopConfig;

/** The converter of the paper's light bulb, with a wall switch and two spare ones. */
final class LampConverter {
    final PushMonitor wallSwitch = new PushMonitor("WallSwitch");
    final SystemEventConverter converter;

    LampConverter(LoopConfig config) {
        converter = new SystemEventConverter(config);
        converter.addMonitor(wallSwitch);
        converter.addExecute(new RecordingExecute("Lamp", "switch"));
        converter.addKnowledge(new LightBulb());
        converter.addKnowledgeFactory(LightBulb::new);
        converter.addSpare("spareSwitch", () -> new PushMonitor("SpareSwitch"));
        converter.addSpare("otherSwitch", () -> new PushMonitor("OtherSwitch"));
        converter.build();
    }

    /** A command that presses the switch and processes the event, in a converter without threads. */
    ConsoleCommand switchCommand() {
        return ConsoleCommand.of("switch", "operates the wall switch\nlike a finger", (arguments, out) -> {
            wallSwitch.press("switch");
            converter.observe(wallSwitch);
            converter.step();
        });
    }
}
