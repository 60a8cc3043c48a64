package org.evoloop.mqtt;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;

/** Which classes may use the MQTT client. */
@AnalyzeClasses(packages = "org.evoloop.mqtt", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule theClientIsKnownInOnePlace = noClasses()
            .that()
            .haveNameNotMatching(".*\\.(Hive.*|BrokerFailure)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("com.hivemq..", "io.netty..", "io.reactivex..");

    @ArchTest
    static final ArchRule theConnectionKnowsNothingOfHomeAssistant = noClasses()
            .that()
            .resideOutsideOfPackage("org.evoloop.mqtt.home")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.evoloop.mqtt.home");
}
