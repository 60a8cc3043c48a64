package org.evoloop.models.format;

import java.util.List;
import java.util.Random;

/** Statements of PlantUML that declare, describe and connect a few ids in nested states. */
final class RandomPlantUml {
    private static final List<String> IDS = List.of("A", "B", "C", "D", "E", "Long_id", "x1", "点");
    private static final List<String> ARROWS =
            List.of("-->", "->", "-up->", "-[#red,dashed]->", "-left[bold]->", "<--", "x->o", "-d->");
    private static final List<String> LABELS =
            List.of("", " : go", ": go", ":go", " : go [x > 1] / f(1)", " : a:b c", ":two words", " /' no '/");

    private final Random random;
    private final StringBuilder text = new StringBuilder("@startuml\n");

    private RandomPlantUml(Random random) {
        this.random = random;
    }

    static String draw(Random random) {
        RandomPlantUml diagram = new RandomPlantUml(random);
        // So that PlantUML takes it for a state diagram.
        diagram.line("state First");
        diagram.statements(0);
        return diagram.line("@enduml").text.toString();
    }

    private void statements(int depth) {
        for (int i = 1 + random.nextInt(6); i > 0; i--) {
            switch (random.nextInt(depth < 3 ? 8 : 6)) {
                case 0 -> line("state " + any(IDS));
                case 1 -> line(any(IDS) + any(List.of(" : ", ": ", ":")) + "entry / x");
                case 2 -> line("[*] --> " + any(IDS) + any(List.of("", " : / f")));
                case 3 -> line(any(IDS) + " --> [*]" + any(LABELS));
                case 4, 5 -> line(any(IDS) + any(List.of(" ", "")) + "--> " + any(IDS) + any(LABELS));
                case 6 -> line(any(IDS) + " " + any(ARROWS) + " " + any(IDS) + any(LABELS));
                default -> {
                    line("state " + any(List.of("", "\"Name\" as ")) + any(IDS) + any(List.of("", " #pink")) + " {");
                    statements(depth + 1);
                    if (random.nextInt(4) == 0) {
                        line("--");
                        statements(depth + 1);
                    }
                    line("}");
                }
            }
        }
    }

    private RandomPlantUml line(String statement) {
        text.append(statement).append('\n');
        return this;
    }

    private String any(List<String> some) {
        return some.get(random.nextInt(some.size()));
    }
}
