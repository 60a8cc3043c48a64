package org.evoloop.lightbulb;

import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.loop.LoopConfig;
import org.evoloop.service.ServiceOptions;
import org.evoloop.time.Clock;

/** The lamp's converter, without its wires and its journal. */
final class LampConverter {
    private LampConverter() {}

    static SystemEventConverter of(
            ModelPair models, PushMonitor wallSwitch, Lamp lamp, ServiceOptions unattended, Clock clock) {
        SystemEventConverter converter =
                new SystemEventConverter(LoopConfig.defaults("lamp", clock).withPressAge(unattended.pressAge()));
        converter.addMonitor(wallSwitch);
        converter.addExecute(new LampExecute(lamp));
        converter.addKnowledge(new LampKnowledge(models, lamp));
        converter.addKnowledgeFactory(other -> new LampKnowledge(other, lamp));
        return converter;
    }
}
