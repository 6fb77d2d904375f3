<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
  <context>
    <name>Rig</name>
    <message numerus="yes">
      <source>ready (%n day(s) old)</source>
      <translation>
        <numerusform>ready (%n day old)</numerusform>
        <numerusform>ready (%n days old)</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>Time</name>
    <message numerus="yes">
      <source>%n s left</source>
      <translation>
        <numerusform>%n s left</numerusform>
        <numerusform>%n s left</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n min left</source>
      <translation>
        <numerusform>%n min left</numerusform>
        <numerusform>%n min left</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::BatchQueue</name>
    <message numerus="yes">
      <source>%n sherd(s): sure %1, ask %2</source>
      <translation>
        <numerusform>%n sherd: sure %1, ask %2</numerusform>
        <numerusform>%n sherds: sure %1, ask %2</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s), all sure</source>
      <translation>
        <numerusform>%n sherd, all sure</numerusform>
        <numerusform>%n sherds, all sure</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%1 is computed: %n sherd(s).</source>
      <translation>
        <numerusform>%1 is computed: %n sherd.</numerusform>
        <numerusform>%1 is computed: %n sherds.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Paused; %n batch(es) wait.</source>
      <translation>
        <numerusform>Paused; %n batch waits.</numerusform>
        <numerusform>Paused; %n batches wait.</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureStation</name>
    <message numerus="yes">
      <source>%1: %n file(s) imported; it is in the queue.</source>
      <translation>
        <numerusform>%1: %n file imported; it is in the queue.</numerusform>
        <numerusform>%1: %n files imported; it is in the queue.</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::CaptureWizard</name>
    <message numerus="yes">
      <source>The %n photograph(s) of this side so far are safe.</source>
      <translation>
        <numerusform>The %n photograph of this side so far is safe.</numerusform>
        <numerusform>The %n photographs of this side so far are safe.</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>Front: %n sherd(s)</source>
      <translation>
        <numerusform>Front: %n sherd</numerusform>
        <numerusform>Front: %n sherds</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n photograph(s) are safe</source>
      <translation>
        <numerusform>%n photograph is safe</numerusform>
        <numerusform>%n photographs are safe</numerusform>
      </translation>
    </message>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translation>
        <numerusform>%n sherd seen</numerusform>
        <numerusform>%n sherds seen</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::HeaderLine</name>
    <message numerus="yes">
      <source>Disk: room for %n batch(es)</source>
      <translation>
        <numerusform>Disk: room for %n batch</numerusform>
        <numerusform>Disk: room for %n batches</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::PlateView</name>
    <message numerus="yes">
      <source>%n sherd(s) seen</source>
      <translation>
        <numerusform>%n sherd seen</numerusform>
        <numerusform>%n sherds seen</numerusform>
      </translation>
    </message>
  </context>
  <context>
    <name>ostraka::ui::QueueStation</name>
    <message numerus="yes">
      <source>%n batch(es) stopped and need you</source>
      <translation>
        <numerusform>%n batch stopped and needs you</numerusform>
        <numerusform>%n batches stopped and need you</numerusform>
      </translation>
    </message>
  </context>
</TS>
